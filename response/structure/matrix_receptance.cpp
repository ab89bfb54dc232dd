#include "response/structure/matrix_receptance.hpp"

#include <string>
#include <utility>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "dense/lu.hpp"
#include "response/structure/infinite_receptance.hpp"

namespace jointid::response {
namespace {

std::string size_text(const Eigen::MatrixXd& m) { return std::to_string(m.rows()) + " × " + std::to_string(m.cols()); }

void require(const std::string& name, const Eigen::MatrixXd& matrix, Eigen::Index rows, Eigen::Index columns) {
  const InputError::Parts place = {
      .kind = ErrorKind::data, .file = "", .place = "[structure] " + name, .problem = "", .remedy = ""};
  InputError::Parts wrong = place;
  if (matrix.rows() != rows || (columns >= 0 && matrix.cols() != columns)) {
    wrong.problem = "the matrix is " + size_text(matrix) + ", the mass matrix has " + std::to_string(rows) + " rows";
    wrong.remedy = "give all matrices for the same coordinates";
    throw InputError(wrong);
  }
  if (!matrix.allFinite()) {
    wrong.problem = "the matrix has an element that is not finite";
    throw InputError(wrong);
  }
}

Eigen::MatrixXd beside(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd both(a.rows(), a.cols() + b.cols());
  both << a, b;
  return both;
}

}  // namespace

MatrixReceptance::MatrixReceptance(MatrixStructure structure, Eigen::MatrixXd joints, const Eigen::MatrixXd& responses,
                                   const Eigen::MatrixXd& forces)
    : structure_(std::move(structure)), joints_(joints.cols()) {
  const Eigen::Index n = structure_.mass.rows();
  require("mass", structure_.mass, n, n);
  require("damping", structure_.damping, n, n);
  require("stiffness", structure_.stiffness, n, n);
  require("joints", joints, n, -1);
  require("responses", responses, n, -1);
  require("forces", forces, n, -1);
  left_ = beside(joints, responses);
  right_ = beside(joints, forces);
}

Eigen::MatrixXcd MatrixReceptance::dynamic_stiffness(double omega) const {
  Eigen::MatrixXcd z(structure_.mass.rows(), structure_.mass.cols());
  z.real() = structure_.stiffness - omega * omega * structure_.mass;
  z.imag() = omega * structure_.damping;
  return z;
}

Eigen::MatrixXcd MatrixReceptance::at(double omega) const {
  const Eigen::MatrixXcd h = left_.transpose() * dense::solve(dynamic_stiffness(omega), right_.cast<Complex>());
  require_finite(h, omega);
  return h;
}

std::optional<Eigen::MatrixXcd> MatrixReceptance::derivative(double omega) const {
  const Eigen::MatrixXcd z = dynamic_stiffness(omega);
  Eigen::MatrixXcd by_omega(z.rows(), z.cols());
  by_omega.real() = -2.0 * omega * structure_.mass;
  by_omega.imag() = structure_.damping;
  const Eigen::MatrixXcd right = dense::solve(z, right_.cast<Complex>()),
                         left = dense::solve(z.transpose(), left_.cast<Complex>());
  Eigen::MatrixXcd slope = -left.transpose() * (by_omega * right);
  require_finite(slope, omega);
  return slope;
}

}  // namespace jointid::response

#include "response/structure/sparse_receptance.hpp"

#include <cmath>
#include <string>

#include "base/error.hpp"
#include "models/sparse_factors.hpp"
#include "response/structure/infinite_receptance.hpp"

namespace jointid::response {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using ComplexSparse = Eigen::SparseMatrix<Complex>;

[[noreturn]] void fail(std::string place, std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::data,
                    .file = "",
                    .place = std::move(place),
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

void require_sparse(const std::string& name, const Sparse& matrix, Eigen::Index n) {
  if (matrix.rows() != n || matrix.cols() != n) fail(name, "has another size than the mass matrix", "");
  for (Eigen::Index k = 0; k < matrix.outerSize(); ++k) {
    for (Sparse::InnerIterator entry(matrix, k); entry; ++entry) {
      if (!std::isfinite(entry.value())) fail(name, "has an element that is no number", "");
    }
  }
}

Eigen::MatrixXcd columns(const Eigen::MatrixXd& first, const Eigen::MatrixXd& second) {
  Eigen::MatrixXcd both(first.rows(), first.cols() + second.cols());
  both << first.cast<Complex>(), second.cast<Complex>();
  return both;
}

ComplexSparse dynamic_stiffness(const SparseStructure& structure, double omega) {
  ComplexSparse z = (structure.stiffness - omega * omega * structure.mass).cast<Complex>();
  z += Complex(0.0, omega) * structure.damping.cast<Complex>();
  z.makeCompressed();
  return z;
}

/// P Z Q = L U.
class Factors {
 public:
  explicit Factors(const SparseStructure& structure, double omega) : omega_(omega) {
    if (!lu_.factorize(dynamic_stiffness(structure, omega))) infinite_receptance(omega);
  }

  Eigen::MatrixXcd solve(const Eigen::MatrixXcd& right) const {
    Eigen::MatrixXcd found = lu_.solve(right);
    require_finite(found, omega_);
    return found;
  }

 private:
  double omega_;
  models::SparseFactors lu_;
};

}  // namespace

SparseReceptance::SparseReceptance(SparseStructure structure, const Eigen::MatrixXd& joints, const Eigen::MatrixXd& responses,
                                   const Eigen::MatrixXd& forces)
    : structure_(std::move(structure)), joints_(joints.cols()) {
  const Eigen::Index n = structure_.mass.rows();
  require_sparse("mass", structure_.mass, n);
  require_sparse("damping", structure_.damping, n);
  require_sparse("stiffness", structure_.stiffness, n);
  if (joints.rows() != n || responses.rows() != n || forces.rows() != n) {
    fail("joints, responses and forces", "have another number of rows than the mass matrix", "");
  }
  left_ = columns(joints, responses);
  right_ = columns(joints, forces);
}

Eigen::MatrixXcd SparseReceptance::at(double omega) const { return left_.transpose() * Factors(structure_, omega).solve(right_); }

std::optional<Eigen::MatrixXcd> SparseReceptance::derivative(double omega) const {
  const Factors factors(structure_, omega);
  const Eigen::MatrixXcd right = factors.solve(right_), left = factors.solve(left_);  // Zᵀ = Z
  ComplexSparse by_omega = (-2.0 * omega * structure_.mass).cast<Complex>();
  by_omega += Complex(0.0, 1.0) * structure_.damping.cast<Complex>();
  return Eigen::MatrixXcd(-left.transpose() * (by_omega * right));
}

}  // namespace jointid::response

#include "models/modal_model.hpp"

#include <utility>

#include "base/eigen.hpp"
#include "base/error.hpp"

namespace jointid::models {
namespace {

/// The rows of the shapes that are asked for.
template <class Shapes>
Eigen::MatrixXcd rows_of(const Shapes& shapes, std::span<const std::size_t> rows) {
  Eigen::MatrixXcd out(at(rows.size()), shapes.cols());
  for (std::size_t r = 0; r < rows.size(); ++r) out.row(at(r)) = shapes.row(at(rows[r])).template cast<Complex>();
  return out;
}

Complex stiffness(const NormalMode& mode, double omega) {
  const double of_mode = mode.angular_frequency;
  return mode.modal_mass * Complex(of_mode * of_mode - omega * omega,
                                   of_mode * of_mode * mode.loss_factor + 2.0 * mode.damping_ratio * of_mode * omega);
}

}  // namespace

ModalModel::ModalModel(Modes modes) : modes_(std::move(modes)) {
  if (modes_.normal_shapes.cols() != at(modes_.normal.size()) || modes_.complex_shapes.cols() != at(modes_.complex.size()) ||
      (!modes_.normal.empty() && !modes_.complex.empty() && modes_.normal_shapes.rows() != modes_.complex_shapes.rows())) {
    refuse("a mode has one shape, and all shapes have as many rows");
  }
  const Eigen::MatrixXcd& residual = modes_.residual;
  if (residual.size() > 0 && (residual.rows() != at(modes_.coordinates()) || residual.cols() != residual.rows())) {
    refuse("the residual has a row and a column for each coordinate");
  }
}

std::optional<Eigen::MatrixXcd> ModalModel::receptance(double omega, std::span<const std::size_t> rows,
                                                       std::span<const std::size_t> columns) {
  count_.columns += columns.size();
  Eigen::MatrixXcd h = Eigen::MatrixXcd::Zero(at(rows.size()), at(columns.size()));
  if (!modes_.normal.empty()) {
    Eigen::MatrixXcd left = rows_of(modes_.normal_shapes, rows);
    for (std::size_t k = 0; k < modes_.normal.size(); ++k) left.col(at(k)) /= stiffness(modes_.normal[k], omega);
    h += left * rows_of(modes_.normal_shapes, columns).transpose();
  }
  if (!modes_.complex.empty()) {
    Eigen::MatrixXcd left = rows_of(modes_.complex_shapes, rows), mirrored = left.conjugate();
    for (std::size_t k = 0; k < modes_.complex.size(); ++k) {
      const auto& [pole, a] = modes_.complex[k];
      left.col(at(k)) /= a * (Complex(0.0, omega) - pole);
      mirrored.col(at(k)) /= std::conj(a) * (Complex(0.0, omega) - std::conj(pole));
    }
    const Eigen::MatrixXcd right = rows_of(modes_.complex_shapes, columns).transpose();
    h += left * right + mirrored * right.conjugate();
  }
  if (modes_.residual.size() > 0) {
    const std::vector<Eigen::Index> r(rows.begin(), rows.end()), c(columns.begin(), columns.end());
    h += modes_.residual(r, c);
  }
  if (!h.allFinite()) return std::nullopt;
  return h;
}

ModelUse ModalModel::use(std::size_t, std::size_t) const { return {.way = ModelWay::modes, .coordinates = size()}; }

}  // namespace jointid::models

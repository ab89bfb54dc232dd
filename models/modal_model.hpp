#pragma once

#include <vector>

#include "base/complex.hpp"
#include "models/model.hpp"

namespace jointid::models {

/// A normal mode: φφᵀ / (m(ω_k²(1 + iη) + 2iζω_kω − ω²)); ω_k = 0 of a rigid body.
struct NormalMode {
  double angular_frequency = 0.0;  ///< ω_k, rad/s, ≥ 0
  double modal_mass = 1.0;         ///< m > 0
  double damping_ratio = 0.0;      ///< ζ ≥ 0
  double loss_factor = 0.0;        ///< η ≥ 0
};

/// A complex mode of real matrices and its conjugate: ψψᵀ/(a(iω − λ)) + conj(ψψᵀ/a)/(iω − conj λ).
struct ComplexMode {
  Complex eigenvalue;  ///< λ, rad/s
  Complex modal_a{1.0};
};

/// Modes of one structure: each column of a matrix of shapes [coordinate, mode] belongs to a mode.
struct Modes {
  Eigen::MatrixXd normal_shapes;
  std::vector<NormalMode> normal;
  Eigen::MatrixXcd complex_shapes;
  std::vector<ComplexMode> complex;
  Eigen::MatrixXcd residual{};  ///< [coordinate, coordinate], m/N: flexibility of modes above those that are there; empty: none

  std::size_t coordinates() const { return static_cast<std::size_t>(std::max(normal_shapes.rows(), complex_shapes.rows())); }
};

/// H as the sum over modes and the residual, by which those above are as flexible as at rest.
class ModalModel final : public Model {
 public:
  /// Throws InputError where shapes and modes are not as many, or the residual has another size.
  explicit ModalModel(Modes modes);

  std::size_t size() const override { return modes_.coordinates(); }
  std::optional<Eigen::MatrixXcd> receptance(double omega, std::span<const std::size_t> rows,
                                             std::span<const std::size_t> columns) override;
  ModelUse use(std::size_t lines, std::size_t coordinates) const override;

 private:
  Modes modes_;
};

}  // namespace jointid::models

#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "models/krylov_basis.hpp"
#include "models/proportional_form.hpp"

namespace jointid::models {

/// Receptances of a large structure by a rational Krylov basis instead of a factorisation for each line: real factorisations of
/// K − s_k M at few shifts or powers of (K + σM)⁻¹M, one real symmetric eigenproblem as large as the basis, and a sum over its
/// modes for each line. α and β leave the eigenvectors as they are, so losses are exact; the coordinates of other dampers are
/// inputs of the basis, and what they do follows by Woodbury's formula.
class Reduction {
 public:
  /// Between these coordinates. `matrices` is kept by reference.
  Reduction(const StructureMatrices& matrices, ProportionalForm form, const std::vector<std::size_t>& coordinates);

  /// Shifts are added until the error that is estimated at test lines over [low, high] (rad/s) is at most `bound` of the largest
  /// FRF of its line, or at most `accepted` once a shift makes it no smaller: that is rounding, of which `rounding` is accepted. Lower
  /// frequencies where it leaves more (a structure that is free to move) are left out. False where that takes more vectors than
  /// `most_vectors`.
  bool cover(double low, double high, Eigen::Index most_vectors);

  bool covers(double omega) const { return omega >= low_ && omega <= high_; }
  bool has(std::span<const std::size_t> coordinates) const;

  /// H(rows, columns) of coordinates that it has; nothing where it is infinite to rounding.
  std::optional<Eigen::MatrixXcd> receptance(double omega, std::span<const std::size_t> rows,
                                             std::span<const std::size_t> columns) const;

  /// The largest error that is estimated at a test line that it covers, over the largest FRF of the line, and where (rad/s). With
  /// the residual r = B − ZVy, at right angles to V, the error is rᵀZ⁻¹r; rᵀG⁻¹r stands for it.
  double error() const { return error_; }
  double worst_omega() const { return worst_; }
  Eigen::Index vectors() const { return basis_ ? basis_->size() : 0; }
  std::size_t shifts() const { return shifts_; }

  static constexpr double bound = 1e-11, accepted = 1e-9, rounding = 1e-7;

 private:
  /// Modes of the basis: ΨᵀVᵀGVΨ = I and ΨᵀVᵀMVΨ = diag(μ), so that Z becomes α + γμ, γ = β − ασ.
  struct Modes {
    Eigen::MatrixXd shapes;  ///< BᵀVΨ
    Eigen::VectorXd mu;
    Eigen::MatrixXd lacking;  ///< ΨᵀVᵀM G⁻¹ MVΨ − diag(μ²)
  };
  bool find_modes();
  /// Vectors where the error is worst: without a factorisation where that is far cheaper and still makes it less, else by a
  /// shift.
  bool extend(double omega, double error, Eigen::Index most_vectors);
  /// A shift for the combinations of inputs that are off by more than the bound there.
  bool add_shift(double omega);
  std::vector<double> test_lines(double low, double high) const;
  /// What is estimated of every FRF, over the largest one.
  Eigen::MatrixXcd errors(double omega) const;
  std::size_t place_of(std::size_t coordinate) const;
  Eigen::ArrayXcd receptances(double omega) const;
  Eigen::MatrixXcd between(const Eigen::ArrayXcd& own, const std::vector<std::size_t>& rows,
                           const std::vector<std::size_t>& columns) const;
  Eigen::MatrixXcd damped(double omega, const std::vector<std::size_t>& rows, const std::vector<std::size_t>& columns) const;

  ProportionalForm form_;
  std::vector<std::size_t> inputs_;  ///< ascending
  std::vector<std::size_t> damper_places_;
  Eigen::VectorXd stiffness_diagonal_, mass_diagonal_;  ///< of the inputs
  const StructureMatrices& matrices_;
  std::optional<KrylovBasis> basis_;
  Modes modes_;
  std::size_t shifts_ = 0;
  bool powers_are_spent_ = false;
  double low_ = 1.0, high_ = 0.0;  ///< nothing yet
  double error_ = 0.0, worst_ = 0.0;
  double aim_ = bound;               ///< what shifts did not mend is rounding, and so is what is smaller
  std::vector<double> at_rounding_;  ///< rad/s, lines that a shift of their own did not mend
};

}  // namespace jointid::models

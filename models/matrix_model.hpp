#pragma once

#include <Eigen/SparseCore>

#include "models/model.hpp"
#include "models/sparse_factors.hpp"

namespace jointid::models {

/// Symmetric N × N matrices in SI units: M ẍ + C ẋ + (K(1 + iη) + iD) x = p.
struct StructureMatrices {
  Eigen::SparseMatrix<double> mass, stiffness;
  Eigen::SparseMatrix<double> viscous_damping, hysteretic_damping;  ///< of no rows: none
  double loss_factor = 0.0;                                         ///< η ≥ 0
};

/// H = (K(1 + iη) + iD + iωC − ω²M)⁻¹, at each ω by one factorisation and a solution for each row or column asked for, whichever
/// are fewer: H is symmetric. Matrices of few rows or many elements are factorised as full ones.
class MatrixModel final : public Model {
 public:
  enum class Factors { by_size, full, sparse };

  /// Throws InputError unless sizes agree.
  explicit MatrixModel(StructureMatrices matrices, Factors factors = Factors::by_size);

  std::size_t size() const override { return static_cast<std::size_t>(matrices_.mass.rows()); }

  /// Infinite: a diagonal element H_kk ≥ 10¹³/|Z_kk|. That of a fine mesh stays far below (a beam of 2,000 elements: 10¹¹), and a
  /// structure that is free to move has 10¹⁵ or more at ω = 0.
  std::optional<Eigen::MatrixXcd> receptance(double omega, std::span<const std::size_t> rows,
                                             std::span<const std::size_t> columns) override;

  bool is_sparse() const { return sparse_; }

 private:
  std::optional<Eigen::MatrixXcd> solve(double omega, std::span<const std::size_t> forces);

  StructureMatrices matrices_;
  Eigen::SparseMatrix<Complex> stiffness_;  ///< K(1 + iη) + iD
  bool sparse_;
  SparseFactors factors_;
};

}  // namespace jointid::models

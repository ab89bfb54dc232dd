#pragma once

#include <memory>
#include <vector>

#include "models/model.hpp"
#include "models/reduction.hpp"
#include "models/sparse_factors.hpp"
#include "models/structure_matrices.hpp"

namespace jointid::models {

/// H = (K(1 + iη) + iD + iωC − ω²M)⁻¹, at each ω by one factorisation and a solution for each row or column asked for, whichever
/// are fewer: H is symmetric. Matrices of few rows or many elements are factorised as full ones. Of sparse ones many lines are
/// taken from a Reduction where C and D permit it, one line of which is compared with a factorisation where that is no great
/// effort, again after the basis has grown.
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

  /// Prepares a Reduction where the lines are so many that it costs less.
  void expect(const Request& request) override;

  ModelUse use(std::size_t lines, std::size_t coordinates) const override;

  const StructureMatrices& matrices() const { return matrices_; }
  bool is_sparse() const { return sparse_; }
  const Reduction* reduction() const { return reduction_.get(); }

 private:
  std::optional<Eigen::MatrixXcd> solve(double omega, std::span<const std::size_t> forces);
  std::optional<Eigen::MatrixXcd> factorised(double omega, std::span<const std::size_t> rows, std::span<const std::size_t> columns);
  /// False, and why, where there is no reduction, or it disagrees with a factorisation at its worst line, which very large ones are
  /// not held against.
  bool reduce(double low, double high);
  bool is_not_reduced(std::string why);
  std::string why_factorised(std::size_t lines) const;
  void predict(std::size_t lines, std::size_t coordinates, ModelUse& out) const;

  StructureMatrices matrices_;
  Eigen::SparseMatrix<Complex> stiffness_;  ///< K(1 + iη) + iD
  bool sparse_;
  SparseFactors factors_;
  bool may_reduce_;
  std::string why_not_reduced_;  ///< once it was tried
  std::size_t lines_asked_ = 0;
  double low_ = 0.0, high_ = 0.0;             ///< range that was reduced, rad/s
  std::vector<std::size_t> reduced_between_;  ///< ascending
  std::optional<ProportionalForm> form_;      ///< once a reduction was asked for
  std::unique_ptr<Reduction> reduction_;
  Eigen::Index compared_vectors_ = 0;  ///< of the basis when it was compared last
};

}  // namespace jointid::models

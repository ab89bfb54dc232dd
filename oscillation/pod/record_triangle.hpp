#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "base/eigen.hpp"
#include "oscillation/pod/tall_triangle.hpp"

namespace jointid::oscillation {

/// Samples of several channels in order of time: a row an instant.
using Samples = RowMatrixXd;

/// The triangle R of [1 X] = QR of a record that comes block by block, by a tall-skinny QR: m + 1 numbers square are kept of any
/// number of samples. The column of ones makes the rest of R the triangle of the record without its mean, to the accuracy of
/// Householder's reflections (squares of samples are never formed, so that σ below 1e-8 σ₁ are not lost). Rows with a number that
/// is not finite are missing samples; they are left out and counted.
class RecordTriangle {
 public:
  /// ≥ 1 channels.
  explicit RecordTriangle(std::size_t channels);

  /// Throws InputError when the block has another number of channels.
  void add(const Eigen::Ref<const Samples>& block);
  /// The record of `other` behind this one.
  void join(const RecordTriangle& other);

  std::size_t channels() const { return rows_.columns(); }
  std::size_t samples() const { return samples_; }  ///< T, the missing ones left out
  std::size_t missing() const { return missing_; }
  Eigen::VectorXd mean() const;
  /// All that it knows as numbers, for another process; and back.
  std::vector<double> numbers() const;
  static RecordTriangle of_numbers(std::size_t channels, const std::vector<double>& numbers);
  /// R_c with R_cᵀR_c = Σ (x − x̄)(x − x̄)ᵀ.
  Eigen::MatrixXd centred() const;
  /// R₀ with R₀ᵀR₀ = Σ x xᵀ.
  Eigen::MatrixXd uncentred() const;

 private:
  Eigen::VectorXd top() const;  ///< R(0, 1 …)
  /// The rows of a triangle below this one.
  void join_rows(double corner, const double* top, const RowMatrixXd& triangle);

  TallTriangle rows_;  ///< of [1 X]
  std::size_t samples_ = 0, missing_ = 0;
};

/// Fills the next rows of a record, of as many numbers as there are channels, at most as many as there is room for, and returns how
/// many; 0 at the end.
using NextSamples = std::function<std::size_t(std::span<double> rows)>;

/// The triangle of a whole record, in blocks of a fixed number of rows whose triangles are joined in their order, so that the
/// result has the same bits for any number of threads ≥ 1. Memory: `threads` blocks.
RecordTriangle record_triangle(std::size_t channels, const NextSamples& next, std::size_t threads = 1);

}  // namespace jointid::oscillation

#pragma once

#include <Eigen/SparseCore>
#include <memory>

#include "base/complex.hpp"

namespace jointid::models {

/// P Z Q = L U of sparse complex matrices with one symmetric pattern: the order of elimination is found for the first of them and
/// kept for the others.
class SparseFactors {
 public:
  SparseFactors();
  ~SparseFactors();
  SparseFactors(const SparseFactors&) = delete;
  SparseFactors& operator=(const SparseFactors&) = delete;

  /// False where Z is singular; solve() is then not to be asked. `z` must be compressed.
  bool factorize(const Eigen::SparseMatrix<Complex>& z);

  /// Z⁻¹ B of the last matrix.
  Eigen::MatrixXcd solve(const Eigen::MatrixXcd& b) const;

 private:
  struct Lu;
  std::unique_ptr<Lu> lu_;
};

}  // namespace jointid::models

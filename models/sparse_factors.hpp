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

/// A = L Lᵀ or L D Lᵀ of a sparse, real, positive definite matrix.
class PositiveFactors {
 public:
  virtual ~PositiveFactors() = default;

  /// False where A is not positive definite. `matrix` symmetric, compressed.
  virtual bool factorize(const Eigen::SparseMatrix<double>& matrix) = 0;

  /// A⁻¹ B
  virtual Eigen::MatrixXd solve(const Eigen::MatrixXd& b) = 0;

  /// Whether columns are put together to blocks, which are as fast as full matrices.
  virtual bool is_supernodal() const = 0;
};

/// Interface of module `cholmod`.
class CholmodModule {
 public:
  virtual ~CholmodModule() = default;
  virtual std::unique_ptr<PositiveFactors> supernodal() = 0;
};

/// Whether module `cholmod` is there.
bool has_cholmod();

/// For matrices of so many rows: large ones by CHOLMOD where its module is there, others by Eigen.
std::unique_ptr<PositiveFactors> positive_factors(Eigen::Index rows);

}  // namespace jointid::models

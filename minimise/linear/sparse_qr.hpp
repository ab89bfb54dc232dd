#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace jointid::minimise {

/// A sparse matrix [rows, columns] by entries, row by row.
struct SparseEntries {
  std::size_t rows = 0, columns = 0;
  std::vector<std::int64_t> row, column;
  std::vector<double> value;
};

/// A(:,permutation) = QR with R [rank, columns] upper trapezoidal, by columns: those of column k are start[k] … start[k + 1].
struct SparseQr {
  std::vector<std::int64_t> start, row;
  std::vector<double> value;
  std::vector<std::int64_t> permutation;  ///< permuted → original column; empty: none
  std::size_t rank = 0;
  std::vector<double> rotated;  ///< Qᵀb
};

/// The lower triangle of a symmetric matrix by columns, rows ascending: those of column k are start[k] … start[k + 1].
struct SparseSymmetric {
  std::vector<std::int64_t> start, row;
  std::vector<double> value;
  std::size_t size() const { return start.size() - 1; }
};

/// The Cholesky factor of a positive definite matrix, ordered by AMD. A pattern is analysed once, when it is first seen.
class SparseFactor {
 public:
  virtual ~SparseFactor() = default;
  /// False where the matrix is not positive definite.
  virtual bool factorize(const SparseSymmetric& matrix) = 0;
  virtual std::vector<double> solve(const std::vector<double>& right) = 0;
  /// Numbers in the factor.
  virtual std::size_t entries() const = 0;
};

/// What the module spqr implements (base/module.hpp).
class SpqrModule {
 public:
  virtual ~SpqrModule() = default;
  /// Columns whose part that is new is shorter than `tolerance` have no pivot.
  virtual SparseQr factor(const SparseEntries& a, const std::vector<double>& b, double tolerance) = 0;
  virtual std::unique_ptr<SparseFactor> cholesky() = 0;
};

/// Rank-revealing QR of a sparse matrix by SuiteSparseQR (Davis 2011). Throws InputError without its module.
SparseQr sparse_qr(const SparseEntries& a, const std::vector<double>& b, double tolerance);

/// CHOLMOD's factor (Chen, Davis, Hager & Rajamanickam 2008). Throws InputError without its module.
std::unique_ptr<SparseFactor> cholmod_cholesky();

/// Eigen's LDLᵀ, which needs no module.
std::unique_ptr<SparseFactor> ldlt_cholesky();

/// Whether the module is there.
bool has_spqr();

}  // namespace jointid::minimise

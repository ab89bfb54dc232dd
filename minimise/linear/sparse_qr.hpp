#pragma once

#include <cstdint>
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

/// What the module spqr implements (base/module.hpp).
class SpqrModule {
 public:
  virtual ~SpqrModule() = default;
  /// Columns whose part that is new is shorter than `tolerance` have no pivot.
  virtual SparseQr factor(const SparseEntries& a, const std::vector<double>& b, double tolerance) = 0;
};

/// Rank-revealing QR of a sparse matrix by SuiteSparseQR (Davis 2011). Throws InputError without its module.
SparseQr sparse_qr(const SparseEntries& a, const std::vector<double>& b, double tolerance);

/// Whether the module is there.
bool has_spqr();

}  // namespace jointid::minimise

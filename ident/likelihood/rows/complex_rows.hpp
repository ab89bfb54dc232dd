#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/complex.hpp"
#include "ident/likelihood/rows/normal_rows.hpp"

namespace jointid::ident {

/// Jᴴ J of weighted complex rows: what NormalRows makes of their real and imaginary parts where both have the same weight, at
/// half the work, and by products of blocks. Every row touches up to two runs of columns, and the tail that all rows have in
/// common.
class ComplexRows {
 public:
  using Run = NormalRows::Run;

  /// Zero, for rows of `columns` numbers of which those from `tail` on are the tail.
  void reset(std::size_t columns, std::size_t tail);

  std::size_t columns() const { return static_cast<std::size_t>(normal_.rows()); }

  /// The lower triangle; of the rows that were added once finish() was called.
  Eigen::MatrixXcd& normal() { return normal_; }
  const Eigen::MatrixXcd& normal() const { return normal_; }

  /// A row: its coefficients in `first`, in `second` (ascending, either may be empty) and in the tail, one after the other.
  void add(const Complex* row, Run first, Run second);

  void finish();

 private:
  struct Row {
    Run first, second;
    std::size_t at = 0;  ///< of its coefficients in heads_
  };

  Eigen::MatrixXcd normal_;
  std::size_t tail_ = 0;
  std::vector<Row> rows_;
  std::vector<Complex> heads_, tails_;  ///< conjugated
};

}  // namespace jointid::ident

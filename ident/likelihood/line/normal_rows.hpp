#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <vector>

namespace jointid::ident {

/// Jᵀ J of weighted real rows of which each touches a few runs of neighbouring columns: the lower triangle, column by column.
class NormalRows {
 public:
  /// A run of columns of a row.
  struct Run {
    std::size_t first = 0, count = 0;
  };

  /// Zero, for rows of `columns` numbers.
  void reset(std::size_t columns);

  std::size_t columns() const { return columns_; }
  double* data() { return values_.data(); }
  const double* data() const { return values_.data(); }

  /// Coefficients of the row to be added, those of its runs one after the other; zero at first.
  double* real() { return real_.data(); }
  double* imaginary() { return imaginary_.data(); }

  /// Adds real()ᵀ real() and imaginary()ᵀ imaginary(); `runs` are ascending and do not overlap, empty ones are allowed.
  void add(const std::array<Run, 3>& runs);

 private:
  std::size_t columns_ = 0;
  std::vector<double> values_, real_, imaginary_;
};

}  // namespace jointid::ident

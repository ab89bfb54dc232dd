#pragma once

#include <cstddef>
#include <vector>

#include "ident/likelihood/rows/normal_kernels.hpp"

namespace jointid::ident {

/// For so many numbers; room that there is stays, and is not cleared again.
inline void make_room(std::vector<double>& of, std::size_t numbers) {
  if (of.size() < numbers) of.resize(numbers);
}

/// Jᵀ J of weighted real rows, each of which touches up to two runs of neighbouring columns and the tail that all rows have in common:
/// the lower triangle, column by column. Rows are kept by their runs and added up by products of blocks (normal_kernels.hpp).
class NormalRows {
 public:
  /// A run of columns of a row.
  struct Run {
    std::size_t first = 0, count = 0;
  };

  /// Zero, for rows of `columns` numbers of which those from `tail` on are the tail.
  void reset(std::size_t columns, std::size_t tail);

  std::size_t columns() const { return columns_; }

  /// The matrix, as eliminate() takes it; of the rows that were added once finish() was called.
  std::size_t stride() const { return stride_; }
  double* block(std::size_t row, std::size_t column) { return values_.data() + column * stride_ + row; }
  double* values() { return values_.data(); }
  const double* values() const { return values_.data(); }
  std::size_t room() const { return columns_ * stride_ + kernel_width; }  ///< numbers

  /// Coefficients of the row to be added, those of its runs and its tail one after the other; zero at first.
  double* real() { return real_.data(); }
  double* imaginary() { return imaginary_.data(); }

  /// Adds real()ᵀ real() and imaginary()ᵀ imaginary(); runs are ascending and do not overlap, empty ones are allowed. Runs that begin
  /// at the same column are as long.
  void add(Run first, Run second);

  void finish();

 private:
  /// Rows of numbers, filled up with zeros to what the kernels take.
  class Pile {
   public:
    void clear() { size_ = 0; }
    std::size_t size() const { return size_; }
    const double* data() const { return numbers_.data(); }
    void append(const double* from, std::size_t count);

   private:
    std::vector<double> numbers_;  ///< room is kept
    std::size_t size_ = 0;
  };

  /// Rows that touch a run: their coefficients in it and in the tail.
  struct Touching {
    Run run;
    Pile heads, tails;
  };

  Touching& touching(Run run);
  void add_square(const Pile& rows, std::size_t at, std::size_t count);
  std::size_t columns_ = 0, tail_ = 0, stride_ = 0;
  std::vector<double> values_, real_, imaginary_;
  Pile tails_;  ///< of all rows
  std::vector<Touching> touching_;
  std::vector<std::size_t> place_;  ///< [columns] in touching_, of the run that begins there
};

}  // namespace jointid::ident

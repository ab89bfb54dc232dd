#include "ident/likelihood/rows/normal_rows.hpp"

#include <algorithm>
#include <limits>

#include "ident/likelihood/rows/normal_kernels.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

}  // namespace

void NormalRows::Pile::append(const double* from, std::size_t count) {
  const std::size_t all = widths_of(count);
  if (size_ + all > numbers_.size()) numbers_.resize(2 * (size_ + all));
  std::copy_n(from, count, numbers_.data() + size_);
  std::fill_n(numbers_.data() + size_ + count, all - count, 0.0);
  size_ += all;
}

void NormalRows::reset(std::size_t columns, std::size_t tail) {
  if (columns != columns_ || tail != tail_) {
    touching_.clear();
    place_.assign(columns, nowhere);
  }
  columns_ = columns;
  tail_ = tail;
  stride_ = widths_of(columns);
  make_room(values_, room());
  for (std::size_t j = 0; j < columns; ++j) std::fill_n(block(lower_part(j), j), stride_ - lower_part(j), 0.0);
  std::fill_n(block(0, columns), kernel_width, 0.0);
  real_.assign(columns, 0.0);
  imaginary_.assign(columns, 0.0);
  tails_.clear();
  for (Touching& each : touching_) {
    each.heads.clear();
    each.tails.clear();
  }
}

NormalRows::Touching& NormalRows::touching(Run run) {
  std::size_t& place = place_[run.first];
  if (place == nowhere) {
    place = touching_.size();
    touching_.push_back({run, {}, {}});
  }
  return touching_[place];
}

void NormalRows::add(Run first, Run second) {
  const std::size_t head = first.count + second.count, width = columns_ - tail_;
  for (const double* row : {real(), imaginary()}) tails_.append(row + head, width);
  std::size_t at = 0;
  for (const Run run : {first, second}) {
    if (run.count == 0) continue;
    Touching& of = touching(run);
    for (const double* row : {real(), imaginary()}) {
      of.heads.append(row + at, run.count);
      of.tails.append(row + head, width);
    }
    at += run.count;
  }
  for (std::size_t i = 0; i < first.count && second.count > 0; ++i) {
    double* const column = values_.data() + (first.first + i) * stride_ + second.first;
    for (std::size_t j = 0; j < second.count; ++j) {
      column[j] += real_[i] * real_[first.count + j] + imaginary_[i] * imaginary_[first.count + j];
    }
  }
  std::fill_n(real_.begin(), head + width, 0.0);
  std::fill_n(imaginary_.begin(), head + width, 0.0);
}

/// Their square, from the column `at` on: four columns at a time, below the diagonal.
void NormalRows::add_square(const Pile& rows, std::size_t at, std::size_t count) {
  const std::size_t each = widths_of(count);
  for (std::size_t i = 0; i < count; i += 4) {
    const std::size_t below = i / kernel_width * kernel_width;
    add_products(block(at + below, at + i), stride_, {rows.data() + i, each}, std::min<std::size_t>(4, count - i),
                 {rows.data() + below, each}, each - below, rows.size() / each);
  }
}

void NormalRows::finish() {
  const std::size_t width = widths_of(columns_ - tail_);
  if (tails_.size() > 0) add_square(tails_, tail_, columns_ - tail_);
  for (const auto& [run, heads, tails] : touching_) {
    if (heads.size() == 0) continue;
    const std::size_t each = widths_of(run.count);
    add_square(heads, run.first, run.count);
    add_products(block(tail_, run.first), stride_, {heads.data(), each}, run.count, {tails.data(), width}, width, heads.size() / each);
  }
}

}  // namespace jointid::ident

#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace jointid::ident {

/// Where an element is in the lower triangle of a symmetric matrix, row by row, and how many these are.
inline std::size_t triangle_place(std::size_t row, std::size_t column) {
  if (row < column) std::swap(row, column);
  return row * (row + 1) / 2 + column;
}
constexpr std::size_t triangle_size(std::size_t size) { return size * (size + 1) / 2; }

/// A symmetric n×n matrix, one triangle kept.
template <class T>
class Symmetric {
 public:
  explicit Symmetric(std::size_t size, const T& value = T()) : values_(triangle_size(size), value) {}

  T& at(std::size_t row, std::size_t column) { return values_[triangle_place(row, column)]; }
  const T& at(std::size_t row, std::size_t column) const { return values_[triangle_place(row, column)]; }

 private:
  std::vector<T> values_;
};

}  // namespace jointid::ident

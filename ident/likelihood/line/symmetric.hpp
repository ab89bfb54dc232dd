#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace jointid::ident {

/// A symmetric n×n matrix, one triangle kept.
template <class T>
class Symmetric {
 public:
  explicit Symmetric(std::size_t size, const T& value = T()) : values_(size * (size + 1) / 2, value) {}

  T& at(std::size_t row, std::size_t column) { return values_[place(row, column)]; }
  const T& at(std::size_t row, std::size_t column) const { return values_[place(row, column)]; }

 private:
  static std::size_t place(std::size_t row, std::size_t column) {
    if (row < column) std::swap(row, column);
    return row * (row + 1) / 2 + column;
  }

  std::vector<T> values_;
};

}  // namespace jointid::ident

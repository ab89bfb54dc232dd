#pragma once

#include <cstddef>
#include <span>

namespace jointid::frf {

/// An array [line, row, column], in this order.
template <class T>
struct LineArray {
  std::span<const T> values;
  std::size_t rows;     ///< of a line
  std::size_t columns;  ///< of a row
};

/// The elements of an array on the lines, rows and columns asked for, in the order [line, row, column]: each(element, line).
template <class T, class Each>
void gather_elements(const LineArray<T>& from, std::span<const std::size_t> lines, std::span<const std::size_t> rows,
                     std::span<const std::size_t> columns, std::span<T> out, const Each& each) {
  std::size_t next = 0;
  for (const std::size_t line : lines) {
    for (const std::size_t r : rows) {
      const T* const row = from.values.data() + (line * from.rows + r) * from.columns;
      for (const std::size_t c : columns) out[next++] = each(row[c], line);
    }
  }
}

/// As they are.
template <class T>
void gather_elements(const LineArray<T>& from, std::span<const std::size_t> lines, std::span<const std::size_t> rows,
                     std::span<const std::size_t> columns, std::span<T> out) {
  gather_elements(from, lines, rows, columns, out, [](const T& value, std::size_t) { return value; });
}

}  // namespace jointid::frf

#include "ident/accumulator.hpp"

namespace jointid::ident {

Triangle& Accumulator::triangle(const Columns& columns) {
  const auto found = triangles_.find(columns);
  if (found != triangles_.end()) return found->second;
  return triangles_.emplace(columns, Triangle(columns.size(), reduction_)).first->second;
}

std::size_t Accumulator::rows_pushed() const {
  std::size_t rows = 0;
  for (const auto& [columns, triangle] : triangles_) rows += triangle.rows_pushed();
  return rows;
}

std::size_t Accumulator::bytes() const {
  std::size_t bytes = 0;
  for (const auto& [columns, triangle] : triangles_) bytes += triangle.bytes();
  return bytes;
}

void Accumulator::flush() {
  for (auto& [columns, triangle] : triangles_) triangle.flush();
}

void Accumulator::merge(Accumulator& other) {
  for (auto& [columns, other_triangle] : other.triangles_) triangle(columns).merge(other_triangle);
}

}  // namespace jointid::ident

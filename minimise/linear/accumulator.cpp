#include "minimise/linear/accumulator.hpp"

namespace jointid::minimise {

Triangle& Accumulator::triangle(const Columns& columns) {
  const auto found = triangles_.find(columns);
  if (found != triangles_.end()) return found->second;
  return triangles_.emplace(columns, Triangle(columns.size(), reduction_)).first->second;
}

ComplexTriangle& Accumulator::complex_triangle(const Columns& columns, const Columns& real, const Columns& imaginary) {
  const auto found = complex_.find(columns);
  if (found != complex_.end()) return found->second.triangle;
  return complex_.emplace(columns, ComplexPart{ComplexTriangle(real.size()), real, imaginary}).first->second.triangle;
}

std::size_t Accumulator::rows_pushed() const {
  std::size_t rows = 0;
  for (const auto& [columns, triangle] : triangles_) rows += triangle.rows_pushed();
  return rows;
}

std::size_t Accumulator::bytes() const {
  std::size_t bytes = 0;
  for (const auto& [columns, triangle] : triangles_) bytes += triangle.bytes();
  for (const auto& [columns, part] : complex_) bytes += part.triangle.bytes();
  return bytes;
}

void Accumulator::flush() {
  for (auto& [columns, part] : complex_) part.triangle.pour(part.real, part.imaginary, triangle(columns));
  for (auto& [columns, triangle] : triangles_) triangle.flush();
}

void Accumulator::release() {
  complex_.clear();
  for (auto& [columns, triangle] : triangles_) triangle.release();
}

void Accumulator::merge(Accumulator& other) {
  other.flush();
  for (auto& [columns, other_triangle] : other.triangles_) triangle(columns).merge(other_triangle);
}

std::vector<double> Accumulator::packed() {
  flush();
  std::vector<double> out;
  for (const auto& [columns, triangle] : triangles_) {
    out.push_back(static_cast<double>(columns.size()));
    out.insert(out.end(), columns.begin(), columns.end());
    triangle.pack(out);
  }
  return out;
}

void Accumulator::merge_packed(std::span<const double> packed) {
  while (!packed.empty()) {
    const auto count = static_cast<std::size_t>(packed.front());
    Columns columns;
    for (const double column : packed.subspan(1, count)) columns.push_back(static_cast<std::size_t>(column));
    packed = packed.subspan(1 + count);
    Triangle other = Triangle::unpacked(count, reduction_, packed);
    triangle(columns).merge(other);
    packed = packed.subspan(Triangle::packed_size(count));
  }
}

void Accumulator::clear() {
  triangles_.clear();
  complex_.clear();
}

}  // namespace jointid::minimise

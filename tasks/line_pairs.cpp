#include "tasks/line_pairs.hpp"

#include <algorithm>
#include <span>

namespace jointid::tasks {

LinePairs::LinePairs(const std::vector<ident::Line>& lines, ident::Rectangle substructures, ident::Rectangle assembly)
    : lines_(lines), substructures_(std::move(substructures)), assembly_(std::move(assembly)) {}

void LinePairs::read(std::size_t first, std::size_t last) {
  const std::span chunk = std::span(lines_).subspan(first, last - first);
  std::vector<std::size_t> numbers(chunk.size());
  std::ranges::transform(chunk, numbers.begin(), &ident::Line::substructures);
  substructures_.read(numbers);
  std::ranges::transform(chunk, numbers.begin(), &ident::Line::assembly);
  assembly_.read(numbers);
}

}  // namespace jointid::tasks

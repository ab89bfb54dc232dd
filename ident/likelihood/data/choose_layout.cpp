#include "ident/likelihood/data/choose_layout.hpp"

#include <algorithm>

namespace jointid::ident {
namespace {

using Lines = std::vector<BothSystems<Measured>>;

/// Column by column; one triangle of a square block.
std::vector<Element> all_elements(std::size_t rows, std::size_t columns, bool triangle) {
  std::vector<Element> all;
  for (std::size_t column = 0; column < columns; ++column) {
    for (std::size_t row = 0; row < (triangle ? column + 1 : rows); ++row) all.push_back({row, column});
  }
  return all;
}

/// Those that are not zero on every line; `get`(line, element).
template <class Get>
std::vector<Element> without_zeros(std::vector<Element> elements, const Lines& lines, Get get) {
  std::erase_if(elements, [&](const Element& e) {
    return std::all_of(lines.begin(), lines.end(), [&](const auto& line) { return get(line, e).is_zero(); });
  });
  return elements;
}

/// Those of them that some line knows.
template <class Get>
std::vector<Element> measured(const std::vector<Element>& elements, const Lines& lines, Get get) {
  std::vector<Element> left = without_zeros(elements, lines, get);
  std::erase_if(left, [&](const Element& e) {
    return std::none_of(lines.begin(), lines.end(), [&](const auto& line) { return get(line, e).known(); });
  });
  return left;
}

/// Takes the elements of a block that begins at `origin` from one system.
auto block(Symmetric<Measured> BothSystems<Measured>::*system, Element origin) {
  return [=](const BothSystems<Measured>& line, const Element& e) {
    return (line.*system).at(origin.row + e.row, origin.column + e.column);
  };
}

void count_columns(LineLayout& layout) {
  layout.x_first.assign(layout.others + 1, 0);
  for (const Element& e : layout.x) ++layout.x_first[e.column + 1];
  for (std::size_t k = 0; k < layout.others; ++k) layout.x_first[k + 1] += layout.x_first[k];
}

}  // namespace

LineLayout choose_layout(const Dofs& coordinates, std::size_t others, const Lines& lines) {
  const std::size_t n = others, joint = coordinates.size() - others;
  const auto jn = all_elements(joint, n, false), jj = all_elements(joint, joint, true), nn = all_elements(n, n, true);
  const auto sub = &BothSystems<Measured>::substructures, whole = &BothSystems<Measured>::assembly;
  const auto difference = [](const BothSystems<Measured>& line, const Element& e) {
    return line.substructures.at(e.row, e.column) - line.assembly.at(e.row, e.column);
  };
  LineLayout out{.coordinates = coordinates,
                 .others = n,
                 .joint = joint,
                 .x = without_zeros(jn, lines, block(sub, {n, 0})),
                 .x_first = {},
                 .y = without_zeros(jj, lines, block(sub, {n, n})),
                 .a = measured(jn, lines, block(whole, {n, 0})),
                 .b = measured(jj, lines, block(whole, {n, n})),
                 .d = measured(nn, lines, difference)};
  count_columns(out);
  return out;
}

LineLayout without(LineLayout layout, const std::vector<std::size_t>& coordinates) {
  const std::size_t n = layout.others;
  const auto absent = [&](std::size_t coordinate) { return std::ranges::find(coordinates, coordinate) != coordinates.end(); };
  std::erase_if(layout.x, [&](const Element& e) { return absent(e.column); });
  std::erase_if(layout.a, [&](const Element& e) { return absent(e.column) || absent(n + e.row); });
  std::erase_if(layout.b, [&](const Element& e) { return absent(n + e.row) || absent(n + e.column); });
  std::erase_if(layout.d, [&](const Element& e) { return absent(e.row) || absent(e.column); });
  count_columns(layout);
  return layout;
}

}  // namespace jointid::ident

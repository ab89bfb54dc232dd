#include "ident/likelihood/data/choose_layout.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace jointid::ident {
namespace {

/// Column by column; one triangle of a square block.
std::vector<Element> all_elements(std::size_t rows, std::size_t columns, bool triangle) {
  std::vector<Element> all;
  for (std::size_t column = 0; column < columns; ++column) {
    for (std::size_t row = 0; row < (triangle ? column + 1 : rows); ++row) all.push_back({row, column});
  }
  return all;
}

/// The blocks as they come in LineLayout: X, Y, A, B, D.
std::array<std::vector<Element>, 5> all_blocks(std::size_t coordinates, std::size_t others) {
  const std::size_t n = others, joint = coordinates - others;
  const auto jn = all_elements(joint, n, false), jj = all_elements(joint, joint, true), nn = all_elements(n, n, true);
  return {jn, jj, jn, jj, nn};
}

Measured element_of(const BothMeasured& line, std::size_t block, std::size_t n, const Element& e) {
  switch (block) {
    case 0:
      return line.substructures.at(n + e.row, e.column);
    case 1:
      return line.substructures.at(n + e.row, n + e.column);
    case 2:
      return line.assembly.at(n + e.row, e.column);
    case 3:
      return line.assembly.at(n + e.row, n + e.column);
    default:
      return line.substructures.at(e.row, e.column) - line.assembly.at(e.row, e.column);
  }
}

void count_columns(LineLayout& layout) {
  layout.sub_jn_first.assign(layout.others + 1, 0);
  for (const Element& e : layout.sub_jn) ++layout.sub_jn_first[e.column + 1];
  for (std::size_t k = 0; k < layout.others; ++k) layout.sub_jn_first[k + 1] += layout.sub_jn_first[k];
}

}  // namespace

std::vector<double> count_elements(std::size_t coordinates, std::size_t others, const std::vector<BothMeasured>& lines) {
  std::vector<double> counts;
  const auto blocks = all_blocks(coordinates, others);
  for (std::size_t block = 0; block < blocks.size(); ++block) {
    for (const Element& e : blocks[block]) {
      double not_zero = 0.0, known = 0.0;
      for (const BothMeasured& line : lines) {
        const Measured element = element_of(line, block, others, e);
        not_zero += element.is_zero() ? 0.0 : 1.0;
        known += element.known() ? 1.0 : 0.0;
      }
      counts.insert(counts.end(), {not_zero, known});
    }
  }
  return counts;
}

LineLayout choose_layout(const Dofs& coordinates, std::size_t others, const std::vector<double>& counts) {
  constexpr std::size_t measured = 2;  // blocks from A on have only what is known
  auto blocks = all_blocks(coordinates.size(), others);
  std::size_t at = 0;
  for (std::size_t block = 0; block < blocks.size(); ++block) {
    std::erase_if(blocks[block], [&](const Element&) {
      const double not_zero = counts[at++], known = counts[at++];
      return not_zero == 0.0 || (block >= measured && known == 0.0);
    });
  }
  LineLayout out{.coordinates = coordinates,
                 .others = others,
                 .joint = coordinates.size() - others,
                 .sub_jn = std::move(blocks[0]),
                 .sub_jn_first = {},
                 .sub_jj = std::move(blocks[1]),
                 .asm_jn = std::move(blocks[2]),
                 .asm_jj = std::move(blocks[3]),
                 .drop_nn = std::move(blocks[4])};
  count_columns(out);
  return out;
}

LineLayout without(LineLayout layout, const std::vector<std::size_t>& coordinates) {
  const std::size_t n = layout.others;
  const auto absent = [&](std::size_t coordinate) { return std::ranges::find(coordinates, coordinate) != coordinates.end(); };
  std::erase_if(layout.sub_jn, [&](const Element& e) { return absent(e.column); });
  std::erase_if(layout.asm_jn, [&](const Element& e) { return absent(e.column) || absent(n + e.row); });
  std::erase_if(layout.asm_jj, [&](const Element& e) { return absent(n + e.row) || absent(n + e.column); });
  std::erase_if(layout.drop_nn, [&](const Element& e) { return absent(e.row) || absent(e.column); });
  count_columns(layout);
  return layout;
}

}  // namespace jointid::ident

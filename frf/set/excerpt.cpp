#include "frf/set/excerpt.hpp"

#include <algorithm>
#include <numeric>

namespace jointid::frf {
namespace {

std::vector<std::size_t> all_of(std::size_t count) {
  std::vector<std::size_t> indices(count);
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  return indices;
}

Excerpt placed(FrfSet set, const FrfHeader& from, const Block& block) {
  Excerpt out{.set = std::move(set), .line_start = {}, .entry = {}, .shared = {}};
  const std::size_t columns = from.reference.size();
  for (const std::size_t line : block.lines) out.line_start.push_back(line * from.entries());
  std::vector<std::size_t> mirrored_row;
  for (const std::size_t c : block.references) mirrored_row.push_back(find_coordinate(from.response, from.reference[c]));
  for (const std::size_t r : block.responses) {
    const std::size_t mirrored_column = find_coordinate(from.reference, from.response[r]);
    for (std::size_t i = 0; i < block.references.size(); ++i) {
      const std::size_t entry = r * columns + block.references[i];
      const bool has_both = mirrored_row[i] != npos && mirrored_column != npos;
      out.entry.push_back(entry);
      out.shared.push_back(has_both ? std::min(entry, mirrored_row[i] * columns + mirrored_column) : entry);
    }
  }
  return out;
}

}  // namespace

Excerpt whole(FrfSet set) {
  const FrfHeader header = set.header;
  const auto lines = all_of(header.lines()), rows = all_of(header.response.size()), columns = all_of(header.reference.size());
  return placed(std::move(set), header, {lines, rows, columns});
}

Excerpt excerpt(FrfSource& source, const Block& block) { return placed(load(source, block), source.header(), block); }

}  // namespace jointid::frf

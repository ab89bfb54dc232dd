#include "frf/file/number_cell.hpp"

#include "frf/set/unit_label.hpp"
#include "frf/text/number_text.hpp"

namespace jointid::frf {

std::optional<std::string_view> read_number_cell(std::string_view cell, bool comma, double& value) {
  if (parse_cell(cell, comma, value)) return std::string_view();
  const std::size_t blank = cell.find(' ');
  if (blank == std::string_view::npos || !parse_cell(cell.substr(0, blank), comma, value)) return std::nullopt;
  const std::string_view label = trimmed(cell.substr(blank));
  const auto unit = parse_unit(label);
  return unit && unit->same_dimension({1.0, 0, 1, 0}) ? std::optional(label) : std::nullopt;
}

}  // namespace jointid::frf

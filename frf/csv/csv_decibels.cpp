#include "frf/csv/csv_decibels.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "frf/set/unit_label.hpp"
#include "frf/set/units.hpp"
#include "frf/text/label_text.hpp"
#include "frf/text/number_text.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

constexpr const char* give_reference =
    "state what 0 dB is, e.g. [dB re 1 g/N] in the title or # unit = dB re 1 g/N, or export magnitudes";

struct DecibelReference {
  double value = 1.0;
  std::string unit;
};

bool is_in_decibels(std::string_view label) {
  const std::string plain = lower_case(label);
  return plain == "db" || plain.starts_with("db ") || plain.starts_with("db(") || plain.starts_with("db,") ||
         plain.starts_with("db/");
}

/// Of "dB re 1e-6 m/N", "dB (re g/N)" and "dB/1.0 g/N".
std::optional<DecibelReference> reference_of_decibels(std::string_view label) {
  std::string_view rest = trimmed(label.substr(std::min<std::size_t>(2, label.size())));
  while (!rest.empty() && (rest.front() == ',' || rest.front() == ' ')) rest.remove_prefix(1);
  if (rest.starts_with('(') && rest.ends_with(')')) rest = trimmed(rest.substr(1, rest.size() - 2));
  const std::size_t word = std::min(rest.find(' '), rest.size());
  const std::string re = lower_case(rest.substr(0, word));
  const bool stroke = rest.starts_with('/');
  if (!stroke && re != "re" && re != "re." && re != "re:" && re != "rel" && re != "rel." && re != "ref" && re != "ref." && re != "ref:")
    return std::nullopt;
  rest = trimmed(rest.substr(stroke ? 1 : word));
  DecibelReference reference;
  const std::size_t end = std::min(rest.find(' '), rest.size());
  double value = 0.0;
  if (end > 0 && end < rest.size() && parse_cell(rest.substr(0, end), false, value)) {
    if (!(value > 0.0)) return std::nullopt;
    reference.value = value;
    rest = trimmed(rest.substr(end));
  }
  reference.unit = as_ratio(std::string(without_brackets(rest)));
  return quantity_of_unit(reference.unit) ? std::optional(reference) : std::nullopt;
}

void to_magnitudes(CsvTable& table, std::size_t column, const DecibelReference& reference) {
  for (std::size_t row = 0; row < table.rows(); ++row) {
    double& cell = table.cells[row * table.columns.size() + column];
    cell = reference.value * std::pow(10.0, cell / 20.0);
  }
  table.units[column] = reference.unit;
}

}  // namespace

void resolve_decibels(CsvTable& table, const CsvColumns& columns, bool unit_given) {
  const auto key = table.keys.find("unit");
  const bool by_key = key != table.keys.end() && is_in_decibels(key->second);
  for (const auto& [pair, of_pair] : columns.pairs()) {
    for (const CsvPart part : {CsvPart::re, CsvPart::im}) {
      const std::size_t column = of_pair[part];
      if (column != 0 && is_in_decibels(table.units[column]))
        table.fail(table.units_line, column,
                   "'" + shown_label(table.units[column]) + "': a real or imaginary part is not in decibels",
                   "export real and imaginary parts, or magnitudes and phases");
    }
    const std::size_t column = of_pair[CsvPart::mag];
    if (column == 0) continue;
    const bool own = is_in_decibels(table.units[column]);
    if (!own && !(by_key && states_no_unit(table.units[column]))) continue;
    const std::string label = own && (!by_key || reference_of_decibels(table.units[column])) ? table.units[column] : key->second;
    const auto reference = reference_of_decibels(label);
    if (!reference)
      table.fail(table.units_line, column,
                 "unknown unit '" + shown_label(label) + "': a level in decibels whose reference " +
                     (unit_given ? "the given unit does not state" : "is not understood"),
                 give_reference);
    to_magnitudes(table, column, *reference);
  }
  if (by_key) table.keys.erase(key);
}

}  // namespace jointid::frf

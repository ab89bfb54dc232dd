#include "frf/csv/csv_remarks.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include "base/error.hpp"
#include "frf/csv/csv_keys.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/set/units.hpp"
#include "frf/text/label_text.hpp"
#include "frf/text/number_text.hpp"
#include "frf/text/remarks.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

std::vector<std::string_view> pieces_between(std::string_view text, std::string_view signs) {
  std::vector<std::string_view> pieces;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find_first_of(signs, begin), text.size());
    const std::string_view piece = without_brackets(without_padding(text.substr(begin, end - begin)));
    if (!piece.empty()) pieces.push_back(piece);
    begin = end + 1;
  }
  return pieces;
}

bool is_motion_or_force(std::string_view label) {
  const auto unit = parse_unit(label);
  return unit && unit->si != 1.0 && unit->angle == 0 && (unit->force == 1 || (unit->force == 0 && unit->length == 1 && unit->time < 0));
}

/// A single letter may be anything, but where the line is of a unit or an acceleration.
bool counts(std::string_view label, const std::string& line) {
  if (label.size() > 1) return true;
  return line.find("acc") != std::string::npos || line.find("unit") != std::string::npos || line.find("beschl") != std::string::npos;
}

/// Empty where there is none.
std::string_view unread_unit(const std::string& text) {
  const std::string plain = lower_case(text);
  for (const std::string_view label : ratios_in(text)) {
    const auto unit = quantity_of_unit(label) ? parse_unit(label) : std::nullopt;
    if (unit && unit->si != 1.0) return label;
  }
  constexpr std::string_view separators = ",;:=\t";
  for (std::string_view piece : pieces_between(text, separators)) {
    const auto ratio = quantity_of_unit(piece) ? parse_unit(piece) : std::nullopt;
    if (ratio && ratio->si != 1.0) return piece;
    const std::size_t in = piece.rfind(" in ");
    if (in != std::string_view::npos) piece = without_brackets(without_padding(piece.substr(in + 4)));
    if (is_motion_or_force(piece) && counts(piece, plain)) return piece;
  }
  return {};
}

/// "mm, N, s": nothing but units, a length other than m and a force among them.
bool is_system_of_units(const std::string& text) {
  bool length = false, force = false;
  for (const std::string_view piece : pieces_between(text, ",;:-/ \t")) {
    const auto unit = parse_unit(piece);
    if (!unit) return false;
    length = length || (unit->same_dimension({1.0, 1, 0, 0}) && unit->si != 1.0);
    force = force || unit->same_dimension({1.0, 0, 0, 1});
  }
  return length && force;
}

}  // namespace

void require_no_unit_in_remarks(const std::vector<CsvRemark>& remarks, const std::string& file) {
  constexpr std::size_t longest = 200;
  for (const CsvRemark& remark : remarks) {
    if (remark.text.size() > longest) continue;
    const std::string_view unit = is_system_of_units(remark.text) ? std::string_view(remark.text) : unread_unit(remark.text);
    if (unit.empty()) continue;
    throw InputError({.kind = ErrorKind::data,
                      .file = file,
                      .place = "line " + std::to_string(remark.line),
                      .problem = "states the unit '" + shown_label(unit) + "', which is not read, and nothing else states that of the FRFs",
                      .remedy = "write # unit = ... with that of motion over force, e.g. g/N, or give it: --unit, in a scene unit"});
  }
}

std::string factor_not_applied(const CsvRemark& remark) {
  const CsvNote note = csv_note(remark.text, remark.line, '\0');
  double value = 0.0;
  const bool factor = use_of_number(note.key) != NumberUse::none || may_be_channel_factor(note.key);
  if (!factor || note.value.empty() || !parse_cell(note.value, false, value) || value == 1.0 || value == 0.0) return {};
  return "line " + std::to_string(remark.line) + " states '" + shown_label(note.key) + " = " + shown_label(note.value) +
         "', which is not applied to the FRFs";
}

}  // namespace jointid::frf

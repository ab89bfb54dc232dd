#include "frf/csv/csv_remarks.hpp"

#include <algorithm>
#include <cmath>
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
  return unit && unit->si != 1.0 && unit->angle == 0 &&
         (unit->force == 1 || (unit->force == 0 && unit->length == 1 && unit->time < 0));
}

/// A single letter may be anything, but where the line is of a unit or an acceleration.
bool counts(std::string_view label, const std::string& line) {
  if (label.size() > 1) return true;
  return line.find("acc") != std::string::npos || line.find("unit") != std::string::npos ||
         line.find("beschl") != std::string::npos;
}

/// A unit of a force or a motion in the brackets at the end of a line of a channel, "Response channel: 2 (g)"; else empty.
std::string_view unit_of_channel(const std::string& text) {
  const std::string plain = lower_case(text);
  if (plain.find("resp") == std::string::npos && plain.find("ref") == std::string::npos) return {};
  for (const std::string_view label : labels_in(text)) {
    if (label.size() < text.size() && is_motion_or_force(label)) return without_brackets(label);
  }
  return {};
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
  return unit_of_channel(text);
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

/// "rad/s" of "frequencies in rad/s", where they are read in another unit; empty where nothing is stated.
std::string_view frequencies_in(std::string_view text, double hz_per_unit) {
  const std::string plain = lower_case(text);
  const bool frequencies = plain.starts_with("freq") || plain.starts_with("f in ") || plain.starts_with("omega");
  const std::size_t in = text.rfind(" in ");
  if (!frequencies || in == std::string_view::npos) return {};
  const std::string_view label = without_brackets(without_padding(text.substr(in + 4)));
  const auto unit = parse_unit(label);
  if (!unit || !unit->same_dimension({1.0, 0, -1, 0})) return {};
  constexpr double same = 1e-6;
  const auto hertz = hertz_per(label);
  return hertz && std::abs(*hertz - hz_per_unit) > same * hz_per_unit ? label : std::string_view();
}

/// Whether a unit is that of a ratio or one of its two: "g" of "g/N".
bool is_part_of(std::string_view label, std::string_view ratio) {
  const auto one = parse_unit(label);
  const auto is_same = [&](std::string_view text) {
    const auto other = parse_unit(without_brackets(without_padding(text)));
    return one && other && other->same_dimension(*one) && other->si == one->si;
  };
  const std::size_t stroke = ratio.rfind('/');
  return is_same(ratio) ||
         (stroke != std::string_view::npos && (is_same(ratio.substr(0, stroke)) || is_same(ratio.substr(stroke + 1))));
}

}  // namespace

std::string sensitivity_stated(const CsvRemark& remark) {
  const bool stated = states_sensitivity(remark.text) && factor_not_applied(remark).empty();
  return stated ? "line " + std::to_string(remark.line) + " states '" + shown_label(remark.text) +
                      "', and nothing the unit of the FRFs"
                : "";
}

void require_no_unit_in_remarks(const std::vector<CsvRemark>& remarks, const std::string& file) {
  constexpr std::size_t longest = 200;
  for (const CsvRemark& remark : remarks) {
    if (remark.text.size() > longest) continue;
    const std::string_view unit = is_system_of_units(remark.text) ? std::string_view(remark.text) : unread_unit(remark.text);
    if (unit.empty()) continue;
    throw InputError(
        {.kind = ErrorKind::data,
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
  const std::string line = "line " + std::to_string(remark.line) + " states '";
  if (!factor || note.value.empty() || !parse_cell(note.value, false, value))
    return doubts_numbers(remark.text) ? line + shown_label(remark.text) + "'; the FRFs are taken as they are" : std::string();
  if (value == 1.0 || value == 0.0) return {};
  return line + shown_label(note.key) + " = " + shown_label(note.value) + "', which is not applied to the FRFs";
}

std::string other_unit_stated(const CsvRemark& remark, const std::string& unit, double hz_per_unit) {
  constexpr std::size_t longest = 200;
  if (remark.text.size() > longest) return {};
  const std::string line = "line " + std::to_string(remark.line) + " states the unit '";
  if (const std::string_view hertz = frequencies_in(remark.text, hz_per_unit); !hertz.empty())
    return line + shown_label(hertz) + "' of frequencies, and they are read in another";
  std::vector<std::string_view> pieces = pieces_between(remark.text, ",;:=");
  if (!pieces.empty()) pieces.erase(pieces.begin());  // what is before the first of these signs is a name
  const auto no_unit = std::ranges::find_if(pieces, [](auto piece) { return !parse_unit(piece) && !not_a_unit(piece).empty(); });
  const std::string_view other = no_unit != pieces.end() ? *no_unit : unread_unit(remark.text);
  if (other.empty() || is_part_of(other, unit)) return {};
  return line + shown_label(other) + "', and the FRFs are read in '" + shown_label(unit) + "'";
}

}  // namespace jointid::frf

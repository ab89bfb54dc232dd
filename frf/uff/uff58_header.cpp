#include "frf/uff/uff58_header.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/error.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/text/label_text.hpp"
#include "frf/text/remarks.hpp"
#include "frf/text/unit_names.hpp"
#include "frf/uff/uff_text.hpp"

namespace jointid::frf::uff {
namespace {

constexpr std::array<std::size_t, 6> singles = {13, 13, 13, 13, 13, 13};
constexpr std::array<std::size_t, 4> doubles = {20, 20, 20, 20};
constexpr std::array<std::size_t, 4> uneven_real_doubles = {13, 20, 13, 20};
constexpr std::array<std::size_t, 3> uneven_complex_doubles = {13, 20, 20};

constexpr std::array<const char*, 29> function_names = {"general or unknown function",
                                                        "time response",
                                                        "auto spectrum",
                                                        "cross spectrum",
                                                        "frequency response function",
                                                        "transmissibility",
                                                        "coherence",
                                                        "auto correlation",
                                                        "cross correlation",
                                                        "power spectral density",
                                                        "energy spectral density",
                                                        "probability density function",
                                                        "spectrum",
                                                        "cumulative frequency distribution",
                                                        "peaks valley",
                                                        "stress/cycles",
                                                        "strain/cycles",
                                                        "orbit",
                                                        "mode indicator function",
                                                        "force pattern",
                                                        "partial power",
                                                        "partial coherence",
                                                        "eigenvalue",
                                                        "eigenvector",
                                                        "shock response spectrum",
                                                        "finite impulse response filter",
                                                        "multiple coherence",
                                                        "order function",
                                                        "phase compensation"};

bool is_of_type(const Unit& unit, int type) {
  const auto is = [&](int length, int time, int force) { return unit.same_dimension({1.0, length, time, force}); };
  const bool motion = is(1, 0, 0) || is(1, -1, 0) || is(1, -2, 0);
  if (type == type_displacement || type == type_velocity || type == type_acceleration)
    return motion || (unit.force == -1 && unit.length <= 1);
  if (is_force_type(type)) return is(0, 0, 1) || is(1, 0, 1);
  if (type == type_frequency) return unit.length == 0 && unit.time == -1 && unit.force == 0 && unit.angle == 1;
  return type < 2 && (motion || is(0, 0, 1) || unit.force == -1);
}

/// One header line, read by columns; errors name the record.
class RecordLine {
 public:
  RecordLine(const std::string& line, int record, const Place& place, bool by_bytes = false)
      : raw_(line),
        line_(by_bytes ? line : one_byte_per_column(line)),
        by_bytes_(by_bytes),
        record_("record " + std::to_string(record)),
        place_(place) {}

  std::int64_t integer(std::size_t begin, std::size_t width, const char* what) const {
    const std::string_view field = column(line_, begin, width);
    const auto value = parse_integer(field);
    if (!value) fail(what, field, begin, width);
    return *value;
  }

  int code(std::size_t begin, std::size_t width, const char* what, std::int64_t lowest, std::int64_t highest) const {
    const std::int64_t value = integer(begin, width, what);
    if (value < lowest || value > highest) fail(what, column(line_, begin, width), begin, width);
    return static_cast<int>(value);
  }

  double real(std::size_t begin, std::size_t width, const char* what) const {
    const std::string_view field = column(line_, begin, width);
    const auto value = field.empty() ? 0.0 : parse_real(field);
    if (!value || !std::isfinite(*value)) fail(what, field, begin, width);
    return *value;
  }

  /// Empty where it states nothing.
  std::string text(std::size_t begin, std::size_t width) const {
    const std::string value = by_bytes_ ? utf8_label(column(raw_, begin, width)) : text_column(raw_, begin, width);
    return states_no_unit(value) ? std::string() : value;
  }

  /// A field behind a name that one blank separates from it: by bytes where that blank stands there alone.
  std::string text_behind_name(std::size_t begin, std::size_t width) const {
    if (!has_wide_characters(raw_)) return text(begin, width);
    const bool parted = text_column(raw_, begin - 1, 1).empty() && !text_column(raw_, begin, width).empty();
    if (parted) return text(begin, width);
    const bool parted_by_bytes = column(raw_, begin - 1, 1).empty() && !column(raw_, begin, width).empty();
    return RecordLine(raw_, 0, place_, parted_by_bytes).text(begin, width);
  }

  /// The unit of an axis, in columns 48 to 67; the whole word where a program put it a few columns to the left or to the right.
  std::string unit(int type) const {
    if (has_wide_characters(raw_)) return text_behind_name(begin, end - begin);
    std::size_t from = begin, to = end;
    while (from > name && from <= line_.size() && !is_blank(line_[from - 1])) --from;
    const bool apart = from > name && parse_unit(column(line_, from, end - from));
    if (!apart) from = begin_behind_name(from, type);
    if (to < line_.size() && !is_blank(line_[to - 1]))
      while (to < line_.size() && !is_blank(line_[to])) ++to;
    return text(from, to - from);
  }

  [[noreturn]] void fail(const char* what, std::string_view field, std::size_t begin, std::size_t width) const {
    place_.fail(record_,
                std::string(what) + " '" + to_utf8(field) + "' in columns " + std::to_string(begin + 1) + "-" +
                    std::to_string(begin + width) + " is not valid",
                "the header's fields must be in the columns of the UFF 58 format");
  }

 private:
  static constexpr std::size_t name = 26, begin = 47, end = 67;  // columns of the name and the unit of an axis

  bool is_unit_from(std::size_t from, int type) const {
    const auto unit = parse_unit(column(line_, from, end - from));
    return unit && is_of_type(*unit, type);
  }

  /// Where the unit begins behind a name that fills its field and the blank behind it: there, or one column to the left where
  /// only that is a unit. From the beginning of the word `word`, which is no unit and will be refused, where both may be.
  std::size_t begin_behind_name(std::size_t word, int type) const {
    if (word == begin || !is_unit_from(begin - 1, type)) return begin;
    const bool alone = column(line_, begin, end - begin).empty();
    return alone || is_unit_from(begin, type) ? word : begin - 1;
  }

  static bool is_blank(char c) { return static_cast<unsigned char>(c) <= ' '; }

  std::string raw_;
  std::string line_;
  bool by_bytes_;
  std::string record_;
  const Place& place_;
};

DofRecord parse_dof(const RecordLine& record, std::size_t begin) {
  DofRecord dof;
  dof.node = record.integer(begin + 11, 10, "node");
  dof.direction = record.code(begin + 21, 4, "direction code", -6, 6);
  dof.entity = record.text(begin + 1, 10);
  return dof;
}

constexpr std::size_t wide = 24;

/// Record 7 with its last three columns widened. Six blank-separated words are taken as the fields, whatever
/// their columns: some programs write wider numbers than the format allows.
std::string widened_data_form(const std::string& line) {
  constexpr std::array<std::size_t, 6> begins = {0, 10, 20, 30, 43, 56};
  constexpr std::array<std::size_t, 6> widths = {10, 10, 10, 13, 13, 13};
  constexpr std::array<std::size_t, 6> new_widths = {10, 10, 10, wide, wide, wide};
  const auto fields = words(line);
  std::string columns;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const std::string_view field = fields.size() == 6 ? fields[i] : column(line, begins[i], widths[i]);
    columns += std::string(new_widths[i] - std::min(new_widths[i], field.size()), ' ') + std::string(field);
  }
  return columns;
}

void parse_data_form(Header58& header, const std::string& line, const Place& place) {
  const RecordLine record(widened_data_form(line), 7, place);
  constexpr const char* types = "ordinate data type (2 and 4 are real, 5 and 6 complex, single and double precision)";
  header.ordinate_type = record.code(0, 10, types, 2, 6);
  if (header.ordinate_type == 3) record.fail(types, "3", 0, 10);
  header.points = static_cast<std::uint64_t>(record.code(10, 10, "number of points", 1, 2'147'483'647));
  header.even = record.code(20, 10, "abscissa spacing (0 or 1)", 0, 1) == 1;
  header.abscissa_first = record.real(30, wide, "abscissa minimum");
  header.abscissa_step = record.real(30 + wide, wide, "abscissa increment");
}

/// The unit in the name of an axis, "Acceleration [g]", "NONE g" or "g", where the field of units is blank; empty where it has
/// none.
std::string unit_in_name(std::string_view name, int type) {
  if (name.starts_with("NONE ")) name.remove_prefix(5);
  const std::size_t open = name.find_last_of("[(");
  const bool enclosed = open != std::string_view::npos && open > 0 && (name.ends_with(']') || name.ends_with(')'));
  for (const std::string_view text : {enclosed ? name.substr(open + 1, name.size() - open - 2) : std::string_view(), name}) {
    const auto unit = parse_unit(text);
    if (unit && is_of_type(*unit, type)) return std::string(text);
    if (enclosed && text != name && !not_a_unit(text).empty()) return std::string(text);
  }
  return {};
}

/// Frequencies times 2π, by the name of their axis.
bool is_angular(std::string_view name) {
  constexpr std::array<std::string_view, 8> names = {
      "omega", "w", "\u03C9", "angular frequency", "circular frequency", "kreisfrequenz", "pulsation", "pulsazione"};
  return std::ranges::find(names, lower_case(name)) != names.end();
}

/// Whether a text names a magnitude and a phase: "Mag/Phase", "Amplitude & Phase", "Betrag, Phase".
bool names_polar_parts(std::string_view text) {
  constexpr std::array<std::string_view, 6> magnitudes = {"mag", "magnitude", "amp", "ampl", "amplitude", "betrag"};
  constexpr std::array<std::string_view, 4> phases = {"phase", "ph", "phs", "angle"};
  bool magnitude = false, phase = false;
  const std::string plain = lower_case(text);
  const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
  for (auto begin = std::ranges::find_if(plain, is_letter); begin != plain.end();) {
    const auto end = std::find_if_not(begin, plain.end(), is_letter);
    const std::string_view word(begin, end);
    magnitude = magnitude || std::ranges::find(magnitudes, word) != magnitudes.end();
    phase = phase || std::ranges::find(phases, word) != phases.end();
    begin = std::find_if(end, plain.end(), is_letter);
  }
  return magnitude && phase;
}

/// The first text of the header that does; empty where none does.
std::string polar_text(const Header58& header, const std::string& numerator_line) {
  std::vector<std::string> texts = {to_utf8(trim(column(one_byte_per_column(numerator_line), 26, 20)))};
  texts.insert(texts.end(), header.id.begin(), header.id.end());
  const auto found = std::ranges::find_if(texts, names_polar_parts);
  return found != texts.end() ? *found : std::string();
}

/// Whether a name of an axis is of a force where it is one of motions, or the other way round.
bool names_other_kind(std::string_view name, int type) {
  const std::string plain = lower_case(name);
  const auto has = [&](std::string_view word) { return plain.find(word) != std::string::npos; };
  const bool force = has("force") || has("kraft"), motion = has("accel") || has("veloc") || has("displac") || has("beschl");
  const bool of_motion = type == type_displacement || type == type_velocity || type == type_acceleration;
  return (of_motion && force && !motion) || (is_force_type(type) && motion && !force);
}

/// What the name of an axis states against its unit or its type, "Acceleration (g)" beside m/s^2; a phrase, or empty.
std::string doubt_of_axis(const std::string& line, const AxisRecord& axis, int number) {
  const std::string name = to_utf8(trim(column(one_byte_per_column(line), 26, 20)));
  const std::string where = "record " + std::to_string(number) + " names the axis '" + shown_label(name) + "', and ";
  if (axis.unit.empty()) return names_other_kind(name, axis.data_type) ? where + "its type is of another kind" : std::string();
  const auto own = parse_unit(axis.unit), named = parse_unit(unit_in_name(name, axis.data_type));
  const bool other = own && named && own->same_dimension(*named) && own->si != named->si;
  return other ? where + "its unit is '" + shown_label(axis.unit) + "'" : std::string();
}

/// Whether a text ends in a unit of FRFs other than `si`, "Units: g/N".
bool states_other_ratio(std::string_view text, double si) {
  constexpr double same = 1e-6;
  return std::ranges::any_of(labels_in(text), [&](std::string_view label) {
    const Unit unit = label.size() < text.size() ? parse_unit(label).value_or(Unit{}) : Unit{};
    return unit.force == -1 && std::abs(unit.si - si) > same * unit.si;
  });
}

/// What an identification line states of numbers or units that are not those of the axes; a phrase, or empty.
std::string doubt_of_id(const std::vector<std::string>& id, const Header58& header) {
  const Unit none, motion = parse_unit(header.numerator.unit).value_or(none),
                   force = parse_unit(header.denominator.unit).value_or(none);
  for (const std::string& line : id) {
    const std::string start = "an identification line states '" + shown_label(line) + "', and ";
    const bool no_units = header.numerator.unit.empty() && states_sensitivity(line);
    if (doubts_numbers(line) || no_units) return start + "the numbers are taken as they are";
    if (motion.length != 0 && force.force == 1 && states_other_ratio(line, motion.si / force.si))
      return start + "the units of the axes are others";
  }
  return {};
}

AxisRecord parse_axis(const std::string& line, int number, const Place& place) {
  const RecordLine record(line, number, place);
  AxisRecord axis;
  axis.data_type = record.code(0, 10, "specific data type", 0, 999);
  axis.unit = record.unit(axis.data_type);
  const std::string name = record.text(26, 20);
  if (axis.unit.empty()) axis.unit = unit_in_name(name, axis.data_type);
  if (number == 8 && axis.unit.empty() && is_angular(name)) axis.unit = "rad/s";
  return axis;
}

void parse_function(Header58& header, const RecordLine& record) {
  header.function_type = record.code(0, 5, "function type", 0, 9999);
  header.load_case = record.integer(20, 10, "load case");
  header.response = parse_dof(record, 30);
  header.reference = parse_dof(record, 55);
}

/// By bytes where columns of characters make no sense.
void parse_function(Header58& header, const std::string& line, const Place& place) {
  try {
    parse_function(header, RecordLine(line, 6, place));
  } catch (const InputError&) {
    if (!has_wide_characters(line)) throw;
    parse_function(header, RecordLine(line, 6, place, true));
  }
}

}  // namespace

Dof DofRecord::dof() const {
  return {.node = node, .direction = static_cast<Direction>(std::abs(direction)), .sign = direction < 0 ? -1 : +1};
}

std::string DofRecord::name() const { return direction == 0 ? std::to_string(node) + ":scalar" : dof().name(); }

Header58 parse_header58(const std::array<std::string, header_lines>& lines, const Place& place) {
  Header58 header;
  constexpr std::size_t id_lines = 5;
  for (std::size_t i = 0; i < id_lines; ++i) header.id.push_back(to_utf8(trim(one_byte_per_column(lines[i]))));
  parse_function(header, lines[5], place);
  parse_data_form(header, lines[6], place);
  header.abscissa = parse_axis(lines[7], 8, place);
  header.numerator = parse_axis(lines[8], 9, place);
  header.denominator = parse_axis(lines[9], 10, place);
  header.polar = polar_text(header, lines[8]);
  header.doubt = doubt_of_axis(lines[8], header.numerator, 9);
  if (header.doubt.empty()) header.doubt = doubt_of_axis(lines[9], header.denominator, 10);
  if (header.doubt.empty()) header.doubt = doubt_of_id(header.id, header);
  return header;
}

std::span<const std::size_t> text_columns(const Header58& header) {
  if (!header.is_double()) return singles;
  if (header.even) return doubles;
  if (header.is_complex()) return uneven_complex_doubles;
  return uneven_real_doubles;
}

std::vector<double> even_abscissa(const Header58& header) {
  std::vector<double> axis(header.points);
  for (std::size_t i = 0; i < axis.size(); ++i) {
    axis[i] = header.abscissa_first + static_cast<double>(i) * header.abscissa_step;
  }
  return axis;
}

std::string function_name(int function_type) {
  const auto index = static_cast<std::size_t>(function_type);
  return index < function_names.size() ? function_names[index]
                                       : "function of type " + std::to_string(function_type) + " (UFF 58 has 0 to 28)";
}

}  // namespace jointid::frf::uff

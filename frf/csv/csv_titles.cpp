#include "frf/csv/csv_titles.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "frf/csv/csv_functions.hpp"
#include "frf/csv/csv_suffix.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/set/units.hpp"
#include "frf/text/label_text.hpp"
#include "frf/text/number_text.hpp"
#include "frf/text/special_number.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

constexpr std::array<std::string_view, 11> frequency_titles = {"frequency",      "freq",       "frequencies", "frequenz",
                                                               "freq.",          "fréquence",  "frecuencia",  "frequenza",
                                                               "frequency axis", "frequentie", "frekvens"};

/// Of a column that counts the rows.
constexpr std::array<std::string_view, 18> index_titles = {"",      "unnamed: 0", "index", "idx",  "#",   "no",
                                                           "no.",   "nr",         "nr.",   "line", "row", "bin",
                                                           "point", "sample",     "id",    "i",    "n",   "k"};

/// Where the brackets of the unit begin in a title: the last ones that belong together, "Re(H) (m/s^2/N)"; the first where more
/// follows them or they are part of a ratio, "Re (g)/(lbf)", "Re (g)(lbf)".
std::size_t begin_of_unit(std::string_view title) {
  const std::size_t first = title.find_first_of("[(");
  if (first == std::string_view::npos || (title.back() != ')' && title.back() != ']')) return first;
  int depth = 0;
  for (std::size_t at = title.size(); at-- > first;) {
    if (title[at] == ')' || title[at] == ']') ++depth;
    if (title[at] != '(' && title[at] != '[') continue;
    if (--depth > 0) continue;
    const std::string_view before = trimmed(title.substr(0, at));
    const bool side_by_side = first > 0 && title[first - 1] == ' ' && at > 0 && title[at - 1] == ')';
    return before.ends_with('/') || before.ends_with('*') || side_by_side ? first : at;
  }
  return first;
}

/// "Re(H11)", whose brackets hold the name of an FRF.
bool is_function(std::string_view title, std::size_t open) {
  const std::string name = lower_case(title.substr(0, open));
  constexpr std::array<std::string_view, 6> functions = {"re", "im", "real", "imag", "abs", "mag"};
  if (title.back() != ')' || std::ranges::find(functions, name) == functions.end()) return false;
  const std::string_view inside = title.substr(open + 1, title.size() - open - 2);
  return !parse_unit(inside) && unit_hint(inside).empty();
}

/// "H(2,1) Re", whose brackets are of the name of an FRF before its part.
bool is_name_before_part(std::string_view title, std::size_t open) {
  const std::size_t close = title.rfind(')'), last = title.rfind(' ');
  if (close == std::string_view::npos || last == std::string_view::npos || last < close || close < open) return false;
  const std::string_view inside = title.substr(open + 1, close - open - 1);
  return is_csv_part(title.substr(last + 1)) && inside.find_first_not_of("0123456789,;:| +-/RXYZ") == std::string_view::npos;
}

/// "Hz" of "unit: Hz" and "in Hz" between brackets.
std::string_view behind_word_unit(std::string_view inside) {
  if (inside.starts_with("in ") && !quantity_of_unit(inside)) return trimmed(inside.substr(3));
  for (const std::string_view word : {"units", "unit"}) {
    if (!lower_case(inside).starts_with(word)) continue;
    const std::string_view rest = trimmed(inside.substr(word.size()));
    if (rest.starts_with(':') || rest.starts_with('=')) return trimmed(rest.substr(1));
  }
  return inside;
}

/// By the brackets of a title: "4:+Y/1:+Y re (g/N)".
CsvTitle bracketed_title(std::string_view cell) {
  if (function_as_part(cell, false) != cell) return {std::string(cell), {}};
  const std::size_t open = begin_of_unit(cell);
  if (open == std::string_view::npos || is_function(cell, open) || is_name_before_part(cell, open)) return {std::string(cell), {}};
  std::string_view unit = cell.substr(open);
  const char close = unit.front() == '[' ? ']' : ')';
  if (unit.find(close) == unit.size() - 1) unit = unit.substr(1, unit.size() - 2);
  const std::string title(trimmed(cell.substr(0, open))), inside(behind_word_unit(trimmed(unit)));
  if (is_csv_part(inside)) return {title + " " + inside, {}};
  if (says_complex(inside)) return {title, {}};
  return {title, as_ratio(inside)};
}

bool is_known_frequency(std::string_view title) {
  return title == csv_frequency_column || std::ranges::find(frequency_titles, title) != frequency_titles.end();
}

/// Empty where it is no unit of frequency.
std::optional<double> hertz_of_label(std::string_view label) {
  try {
    return hertz_per(label);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// "f" of "f /" and "f in", what stands before a unit in brackets.
std::string without_stroke(std::string_view name) {
  if (name.ends_with('/')) name = trimmed(name.substr(0, name.size() - 1));
  if (name.ends_with(" in")) name = trimmed(name.substr(0, name.size() - 3));
  return std::string(name);
}

/// "частота [Hz]", "Abscissa (kHz)", "Pulsation [rad/s]": any name over a unit of frequencies, but that of a speed, a step or a
/// width, or of what is computed from frequencies.
bool is_frequency_by_unit(const std::string& name, const std::string& unit) {
  constexpr std::array others =
      std::to_array<std::string_view>({"speed", "drehzahl", "rate", "step", "span", "width", "resolution", "delta", "log",
                                       "ratio", "norm", "order", "time", "period", "shift", "natural"});
  const std::string plain = lower_case(plain_label(unit));
  const bool known = (plain.ends_with("hz") || plain.starts_with("rad/s")) && hertz_of_label(unit);
  if (!known || name.empty() || name.find_first_of("0123456789*/^:+") != std::string::npos) return false;
  return std::ranges::none_of(others, [&](std::string_view other) { return name.find(other) != std::string::npos; });
}

/// What parts the name of an axis and its unit.
constexpr std::string_view before_unit = " _,/.:-|";

/// "in Hz" and "Hz_" as "Hz"; "rad_s" and "rad_per_s" as "rad/s".
std::string_view written_out(std::string_view unit) {
  if (unit.starts_with("in ") || unit.starts_with("in_")) unit = trimmed(unit.substr(3));
  while (unit.ends_with('_')) unit.remove_suffix(1);
  constexpr std::array<std::string_view, 6> angular = {"rad_s", "rad_per_s", "rad_sec", "rad_per_sec", "radps", "rads"};
  return std::ranges::find(angular, lower_case(unit)) != angular.end() ? "rad/s" : unit;
}

/// "freq_khz" into "freq" and "khz", as the cell writes them; "f / Hz", "f in Hz" and "ω/(rad/s)" likewise.
void split_unit(CsvTitle& title) {
  const std::string plain = lower_case(title.title);
  const auto rest_behind = [&](std::string_view name) -> std::string_view {
    const bool longer = plain.size() > name.size() + 1 && plain.starts_with(name);
    if (!longer || before_unit.find(plain[name.size()]) == std::string_view::npos) return {};
    const std::size_t begin = plain.find_first_not_of(before_unit, name.size());
    return begin == std::string::npos ? std::string_view() : written_out(std::string_view(title.title).substr(begin));
  };
  for (const std::string_view known : {"frequency", "freq", "f"}) {  // "fHz"
    const std::string_view rest = plain.starts_with(known) ? std::string_view(plain).substr(known.size()) : std::string_view();
    if (rest != "hz" && rest != "khz") continue;
    title = {std::string(known), title.title.substr(known.size())};
    return;
  }
  for (const std::string_view known : frequency_titles) {
    const std::string_view rest = rest_behind(known);
    if (rest.empty()) continue;
    title = {std::string(known), std::string(rest)};
    return;
  }
  for (const std::string_view symbol : {"f", "ν", "w", "ω", "omega"}) {
    const std::string_view rest = rest_behind(symbol);
    const auto hertz = rest.empty() ? std::nullopt : hertz_of_label(rest);
    const bool angular = symbol != "f" && symbol != "ν";
    if (!hertz || (angular && *hertz == 1.0)) continue;
    title = {angular ? "omega" : "f", std::string(rest)};
    return;
  }
}

/// The wide brackets of Japanese and Chinese texts, and angle brackets around a unit, as square ones of ASCII.
std::string with_plain_brackets(std::string_view cell) {
  constexpr std::array wide = std::to_array<std::pair<std::string_view, std::string_view>>(
      {{"［", "["}, {"］", "]"}, {"（", "("}, {"）", ")"}, {"【", "["}, {"】", "]"}, {"／", "/"}});
  std::string text(cell);
  for (const auto& [from, to] : wide) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from)) text.replace(at, from.size(), to);
  }
  const std::size_t open = text.find(" <");  // "Real <g/N>"
  if (open != std::string::npos && text.ends_with('>')) text[open + 1] = '[', text.back() = ']';
  return text;
}

/// A unit that stands where the title of the frequencies should.
bool is_unit_alone(std::string_view plain) {
  return plain == "hz" || plain == "hertz";
}

bool is_number_of_table(std::string_view cell, char separator) {
  double value = 0.0;
  return !cell.empty() && parse_cell(cell, separator != ',' || cell.find(',') != std::string_view::npos, value);
}

/// "H2,1 Mag" of "H2,1(f) Mag": what an FRF depends on is not part of its name.
std::string without_argument(std::string_view cell) {
  for (const std::string_view argument : {"(f)", "(w)", "(ω)", "(jw)", "(jω)", "(iω)"}) {
    const std::size_t at = cell.find(argument);
    if (at == std::string_view::npos || at == 0 || cell[at - 1] == ' ') continue;
    const std::string_view before = cell.substr(0, at);
    if (is_csv_part(before.substr(before.rfind(' ') + 1))) continue;
    return std::string(before) + std::string(cell.substr(at + argument.size()));
  }
  return std::string(cell);
}

/// "Level dB (re 1 g/N)": the decibels belong to the unit, and a level in them is a magnitude.
void take_decibels(CsvTitle& title) {
  std::string plain = lower_case(title.title);
  if (plain.ends_with(" db") && lower_case(title.unit).starts_with("re")) {
    title.title.resize(title.title.size() - 3);
    title.unit = "dB " + title.unit;
    plain = lower_case(title.title);
  }
  const bool level = plain == "level" || plain == "pegel";
  if (level && lower_case(title.unit).starts_with("db")) title.title = "mag";
}

constexpr std::size_t most_lines_above = 1000;

/// The cells of a line that are all numbers, two or more; 0 of any other line.
std::size_t numbers_in(std::string_view line, char separator) {
  std::vector<std::string_view> cells = csv_cells(line, separator == '\0' ? ' ' : separator);
  std::erase_if(cells, [](std::string_view cell) { return cell.empty(); });
  const auto is_number = [&](std::string_view cell) { return is_number_of_table(cell, separator); };
  return cells.size() > 1 && std::ranges::all_of(cells, is_number) ? cells.size() : 0;
}

/// The first line of numbers of a text.
struct FirstRow {
  char separator = '\0';
  std::size_t cells = 0;  ///< 0: none

  explicit FirstRow(std::string_view text) {
    for (std::size_t line = 1; line <= most_lines_above && !text.empty() && cells == 0; ++line) {
      const std::string_view row = trimmed(take_until(text, '\n'));
      separator = csv_separator(row);
      if (!row.empty()) cells = numbers_in(row, separator);
    }
  }

  /// That of the numbers where a line of titles has as many cells by it: "Frequency\tH1; Real\tH1; Imag".
  char separator_of(std::string_view line) const {
    const bool same = cells > 0 && separator != '\0' && csv_cells(line, separator).size() == cells;
    return same ? separator : csv_separator(line);
  }
};

/// Looks for the row of titles line by line.
class HeaderSearch {
 public:
  HeaderSearch(char separator, const FirstRow& row) : given_(separator), row_(row) {}

  /// False once the row is known.
  bool take(std::string_view line, std::size_t number) {
    const std::string_view text = trimmed(line);
    if (text.empty()) return true;
    if (latest_ ? begins_numbers(line) : parts_ && numbers_in(text, parts_->separator) == row_.cells) return false;
    const bool comment = text.front() == '#' || text.front() == '%';
    consider(comment ? text.substr(1) : line, number, comment);
    return true;
  }

  std::optional<CsvHeaderPlace> found() const { return latest_ && !units_ ? latest_ : parts_ ? parts_ : latest_; }

 private:
  void consider(std::string_view line, std::size_t number, bool comment) {
    const char separator = given_ != '\0' ? given_ : row_.separator_of(line);
    if (separator == '\0') return;
    const std::vector<std::string_view> cells = csv_cells(line, separator);
    if (!comment && names_parts(cells, separator)) parts_ = {.line = number, .separator = separator, .index = 0, .any_axis = true};
    const std::size_t index = frequency_title(cells[0]) ? 0 : 1;
    if (cells.size() < 2 + index || (index == 1 && !is_index(cells[0]))) return;
    const auto title = frequency_title(cells[index]);
    if (!title || std::ranges::any_of(cells, [&](std::string_view cell) { return is_number_of_table(cell, separator); })) return;
    const bool units = latest_ && cells.size() == cells_ && is_unit_alone(lower_case(title->title));
    if (units || (latest_ && !commented_ && comment)) return;
    latest_ = CsvHeaderPlace{.line = number, .separator = separator, .index = index, .any_axis = false};
    cells_ = cells.size(), commented_ = comment;
    units_ = std::ranges::all_of(cells, [](std::string_view cell) { return cell.empty() || parse_unit(without_brackets(cell)); });
  }

  /// Of as many cells as the numbers have.
  bool names_parts(const std::vector<std::string_view>& cells, char separator) const {
    if (cells.size() != row_.cells || cells.size() < 2) return false;
    if (std::ranges::any_of(cells, [&](std::string_view cell) { return is_number_of_table(cell, separator); })) return false;
    return std::any_of(cells.begin() + 1, cells.end(), [](std::string_view cell) {
      const std::string title = csv_title(cell).title;
      return is_csv_part(std::string_view(title).substr(title.rfind(' ') + 1));
    });
  }

  static bool is_index(std::string_view cell) { return std::ranges::find(index_titles, lower_case(cell)) != index_titles.end(); }

  /// Whether the line is one of numbers, or of what stands in their place, under the titles.
  bool begins_numbers(std::string_view line) const {
    const std::vector<std::string_view> cells = csv_cells(line, latest_->separator);
    const std::size_t at = latest_->index;
    if (cells.size() <= at + 1 || cells.size() + 1 < cells_ || cells.size() > cells_ + 1) return false;
    return is_number_of_table(cells[at], latest_->separator) ||
           (states_no_value(cells[at]) && is_number_of_table(cells[at + 1], latest_->separator));
  }

  char given_;
  const FirstRow& row_;
  std::optional<CsvHeaderPlace> latest_, parts_;
  std::size_t cells_ = 0;
  bool commented_ = false, units_ = false;  ///< nothing but units
};

}  // namespace

char csv_separator(std::string_view line) {
  for (const char separator : {';', '\t', ','}) {
    if (line.find(separator) != std::string_view::npos) return separator;
  }
  return '\0';
}

std::string as_ratio(std::string unit) {
  const std::size_t between = unit.find(")(");
  if (between != std::string::npos) unit.replace(between, 2, ")/(");
  return unit;
}

std::vector<std::string_view> csv_cells(std::string_view line, char separator) {
  if (line.find('"') == std::string_view::npos) return split(line, separator);
  std::vector<std::string_view> cells;
  bool quoted = false;
  std::size_t begin = 0;
  for (std::size_t at = 0; at <= line.size(); ++at) {
    if (at < line.size() && line[at] == '"') quoted = !quoted;
    if (at < line.size() && (quoted || line[at] != separator)) continue;
    cells.push_back(trimmed(line.substr(begin, at - begin)));
    begin = at + 1;
  }
  return cells;
}

bool are_types(const std::vector<std::string_view>& cells) {
  constexpr std::array types = std::to_array<std::string_view>(
      {"double", "float", "single", "dbl", "sgl", "float64", "float32", "real8", "real*8", "real4", "real*4", "real64", "real32",
       "number", "numeric", "decimal", "f8", "f4", "<f8", "<f4", "r8", "r4", "complex", "complex128", "complex64"});
  bool any = false;
  for (const std::string_view cell : cells) {
    const std::string plain = lower_case(without_brackets(cell));
    const bool format = plain.starts_with("format=") || plain.starts_with("format:");
    const bool type = format || plain.starts_with("dt_") || std::ranges::find(types, plain) != types.end();
    if (!type && !plain.empty()) return false;
    any = any || type;
  }
  return any;
}

CsvTitle csv_title(std::string_view cell) {
  if (const std::string plain = with_plain_brackets(cell); plain != cell) return csv_title(plain);
  for (const std::string_view sign : {", ", ": "}) {  // "H1,2 Real, g/lbf" in quotes, "Real: g/N"
    const std::size_t at = cell.rfind(sign);
    if (at == std::string_view::npos || at == 0) continue;
    const std::string_view unit = trimmed(cell.substr(at + 2));
    if (quantity_of_unit(unit) || is_degrees(unit) || is_radians(unit)) {
      CsvTitle title = csv_title(cell.substr(0, at));
      if (title.unit.empty()) return {std::move(title.title), as_ratio(std::string(unit))};
    }
  }
  if (const std::string plain = without_argument(cell); plain != cell) return csv_title(plain);
  if (const auto over = quantity_over_unit(cell)) return {joined_part(function_as_part(over->title, true)), as_ratio(over->unit)};
  CsvTitle title = bracketed_title(cell);
  take_decibels(title);
  take_ratio(title);
  if (const std::size_t last = title.title.rfind(' '); last < title.title.size() && says_complex(title.title.substr(last)))
    title.title.resize(last);
  title.title = joined_part(part_behind_sign(function_as_part(title.title, !title.unit.empty())));
  return title;
}

std::optional<CsvTitle> frequency_title(std::string_view cell) {
  if (const std::string plain = with_plain_brackets(cell); plain != cell) return frequency_title(plain);
  CsvTitle title = bracketed_title(cell);
  if (!title.unit.empty()) title.title = without_stroke(title.title);
  if (title.unit.empty()) split_unit(title);
  const std::string plain = lower_case(title.title);
  constexpr std::array angular_names = std::to_array<std::string_view>(
      {"omega", "ω", "angular frequency", "circular frequency", "kreisfrequenz", "pulsation", "pulsazione"});
  const bool angular = std::ranges::find(angular_names, plain) != angular_names.end(), alone = is_unit_alone(plain);
  const std::string unit = lower_case(plain_label(title.unit));
  if (angular && (unit == "1/s" || unit == "s^-1" || unit == "s-1")) title.unit = "rad/s";
  if (title.unit.empty()) {
    if (angular) title.unit = "rad/s";
    if (alone) title.unit = title.title;
  }
  if (is_frequency_by_unit(plain, title.unit)) return title;
  const bool symbol = title.title == "f" || ((plain == "f" || plain == "ν") && !title.unit.empty());
  if (angular || alone || symbol || is_known_frequency(lower_case(title.title))) return title;
  return std::nullopt;
}

std::optional<CsvHeaderPlace> find_csv_header(std::string_view text, char separator) {
  const FirstRow row(text);
  HeaderSearch search(separator, row);
  for (std::size_t line = 1; line <= most_lines_above && !text.empty(); ++line) {
    if (!search.take(take_until(text, '\n'), line)) break;
  }
  return search.found();
}

std::size_t line_without_titles(std::string_view text) {
  std::size_t cells_above = 0;
  for (std::size_t line = 1; line <= most_lines_above && !text.empty(); ++line) {
    const std::string_view row = trimmed(take_until(text, '\n'));
    if (row.empty()) continue;
    const char separator = csv_separator(row);
    if (const std::size_t numbers = numbers_in(row, separator); numbers > 0) return numbers == cells_above ? 0 : line;
    std::vector<std::string_view> cells = csv_cells(row, separator == '\0' ? ' ' : separator);
    std::erase_if(cells, [](std::string_view cell) { return cell.empty(); });
    cells_above = cells.size();
  }
  return 0;
}

}  // namespace jointid::frf

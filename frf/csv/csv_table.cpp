#include "frf/csv/csv_table.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "base/error.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/text/label_text.hpp"
#include "frf/text/located.hpp"
#include "frf/text/number_text.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

constexpr std::array<std::string_view, 7> frequency_titles = {"frequency", "freq",      "frequencies",   "frequenz",
                                                              "freq.",     "fréquence", "frequency axis"};
constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";

/// The cells of a line, of which some may stand in quotes with separators inside.
std::vector<std::string_view> cells_of(std::string_view line, char separator) {
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

/// Where the brackets of the unit begin in a title: the last ones that belong together, "Re(H) (m/s^2/N)"; the first where more
/// follows them or they are part of a ratio, "Re (g)/(lbf)".
std::size_t begin_of_unit(std::string_view title) {
  const std::size_t first = title.find_first_of("[(");
  if (first == std::string_view::npos || (title.back() != ')' && title.back() != ']')) return first;
  int depth = 0;
  for (std::size_t at = title.size(); at-- > first;) {
    if (title[at] == ')' || title[at] == ']') ++depth;
    if (title[at] != '(' && title[at] != '[') continue;
    if (--depth > 0) continue;
    const std::string_view before = trimmed(title.substr(0, at));
    return before.ends_with('/') || before.ends_with('*') ? first : at;
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

/// "Frequency [Hz]" into "Frequency" and "Hz"; also with ( ).
std::pair<std::string_view, std::string_view> title_and_unit(std::string_view title) {
  const std::size_t open = begin_of_unit(title);
  if (open == std::string_view::npos || is_function(title, open)) return {title, {}};
  std::string_view unit = title.substr(open);
  const char close = unit.front() == '[' ? ']' : ')';
  if (unit.find(close) == unit.size() - 1) unit = unit.substr(1, unit.size() - 2);
  return {trimmed(title.substr(0, open)), trimmed(unit)};
}

/// Reads a table line by line.
class CsvReader {
 public:
  explicit CsvReader(const std::filesystem::path& path) { table_.file = path.string(); }

  CsvTable read(std::string_view rest) {
    for (line_ = 1; !rest.empty(); ++line_) {
      const std::string_view line = take_until(rest, '\n'), text = trimmed(line);
      if (text.empty() || (line_ == 1 && names_separator(text))) continue;
      if (text.front() == '#' || text.front() == '%') {
        read_csv_key(text, table_.file, line_, table_.keys);
        last_comment_ = trimmed(text.substr(1));
      } else if (table_.columns.empty() && takes_comment_for_header(line)) {
        read_row(line);
      } else if (table_.columns.empty()) {
        read_header(line);
      } else if (table_.lines.empty() && table_.units_line == table_.header_line && is_units(line)) {
        read_units(line);
      } else {
        read_row(line);
      }
    }
    if (!table_.columns.empty()) table_.hz_per_unit = hz_per_unit();
    return std::move(table_);
  }

 private:
  /// `sep=;`, which Excel writes and hides.
  bool names_separator(std::string_view text) {
    if (text.size() < 4 || lower_case(text.substr(0, 4)) != "sep=") return false;
    separator_ = text.size() > 4 ? text[4] : '\t';  // a tab was trimmed
    return true;
  }

  /// Titles in the comment above the numbers, as numpy.savetxt writes them.
  bool takes_comment_for_header(std::string_view line) {
    const char separator = csv_separator(last_comment_);
    double value = 0.0;
    if (separator == '\0' || !parse_cell(cells_of(line, separator).front(), false, value)) return false;
    if (!is_frequency(title_and_unit(cells_of(last_comment_, separator).front()).first)) return false;
    read_header(last_comment_);
    return true;
  }

  static bool is_frequency(std::string_view title) {
    const std::string plain = lower_case(title);
    return plain == csv_frequency_column || std::ranges::find(frequency_titles, plain) != frequency_titles.end();
  }

  void read_header(std::string_view line) {
    if (separator_ == '\0') separator_ = csv_separator(line);
    table_.header_line = table_.units_line = line_;
    for (const std::string_view cell : cells_of(line, separator_)) {
      const auto [title, unit] = title_and_unit(cell);
      table_.columns.emplace_back(title);
      table_.units.emplace_back(unit);
    }
    require_frequency();
  }

  /// Any other text with a comma may get here. Takes the unit out of the title of the first column.
  void require_frequency() {
    std::string title = lower_case(table_.columns[0]);
    std::string& unit = table_.units[0];
    const std::string whole = table_.columns[0] + (unit.empty() ? "" : " [" + unit + "]");
    const bool angular = title == "omega" || title == "ω";
    const bool letter = title == "f" && !unit.empty();
    for (const std::string_view known : frequency_titles) {
      if (unit.empty() && title.size() > known.size() + 1 && title.starts_with(known) &&
          std::string_view(" _,/").find(title[known.size()]) != std::string_view::npos) {
        unit = table_.columns[0].substr(title.find_first_not_of(" _,/", known.size()));
        title = known;
      }
    }
    if (angular && unit.empty()) unit = "rad/s";
    if (title == "hz" && unit.empty()) unit = title;
    const bool known = std::ranges::find(frequency_titles, title) != frequency_titles.end();
    if (known || angular || letter || title == "hz") return;
    table_.fail(table_.header_line, 0, "the first column is '" + whole + "', so it is no table of FRFs",
                "begin the header row with frequency_hz, or give jointid-frf HDF5, UFF or MATLAB");
  }

  double hz_per_unit() const {
    const std::string& own = table_.units[0];
    const auto key = table_.keys.find("frequency_unit");
    const auto parse = [&](const std::string& label, const std::string& place) {
      return located(table_.file, place, [&] { return hertz_per(label).value_or(1.0); });
    };
    const double of_column = parse(own, CsvTable::place(table_.units_line, 0));
    if (key == table_.keys.end()) return of_column;
    const double of_key = parse(key->second, "# frequency_unit");
    if (!own.empty() && of_key != of_column)
      table_.fail(table_.units_line, 0, "the unit '" + own + "' is not that of # frequency_unit, '" + key->second + "'",
                  "remove the wrong one");
    return of_key;
  }

  bool parse(std::string_view cell, double& value) const {
    const bool comma = separator_ != ',' || cell.find(',') != std::string_view::npos;  // in quotes
    return parse_cell(cell, comma, value);
  }

  /// A row without a number, under the titles.
  bool is_units(std::string_view line) const {
    const std::vector<std::string_view> cells = cells_of(line, separator_);
    if (cells.size() != table_.columns.size()) return false;
    const auto empty = [](std::string_view cell) { return cell.empty(); };
    return !std::ranges::all_of(cells, empty) && std::ranges::none_of(cells, [&](std::string_view cell) {
      double value = 0.0;
      return !cell.empty() && parse(cell, value);
    });
  }

  void read_units(std::string_view line) {
    const std::vector<std::string_view> cells = cells_of(line, separator_);
    table_.units_line = line_;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string unit(without_brackets(cells[i]));
      if (unit.empty()) continue;
      if (!table_.units[i].empty() && table_.units[i] != unit)
        table_.fail(line_, i, "the unit is '" + unit + "' here and '" + table_.units[i] + "' in the title",
                    "remove the wrong one");
      table_.units[i] = unit;
    }
  }

  void read_row(std::string_view line) {
    const std::vector<std::string_view> cells = cells_of(line, separator_);
    if (cells.size() != table_.columns.size()) {
      table_.fail(
          line_, std::min(cells.size(), table_.columns.size()) - 1,
          "the line has " + std::to_string(cells.size()) + " cells and the header " + std::to_string(table_.columns.size()),
          "leave cells empty where nothing was measured");
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      double value = 0.0;
      if (!parse(cells[i], value))
        table_.fail(line_, i, "'" + std::string(cells[i]) + "' is not a number",
                    cells[i].ends_with("j)") ? "write the real and the imaginary part to columns of their own"
                                             : "leave the cell empty where nothing was measured");
      require_one_decimal_sign(cells[i], i);
      table_.cells.push_back(value);
    }
    table_.lines.push_back(line_);
  }

  /// 1,234 beside 5.6 may be a thousand and more.
  void require_one_decimal_sign(std::string_view cell, std::size_t column) {
    const bool comma = cell.find(',') != std::string_view::npos, point = cell.find('.') != std::string_view::npos;
    if (comma) comma_line_ = line_;
    if (point) point_line_ = line_;
    if ((!comma && !point) || comma_line_ == 0 || point_line_ == 0) return;
    table_.fail(line_, column,
                "'" + std::string(cell) + "' and line " + std::to_string(comma ? point_line_ : comma_line_) +
                    " have different decimal signs, comma and point",
                "write all numbers with one of them and without marks of thousands");
  }

  CsvTable table_;
  std::size_t line_ = 0, comma_line_ = 0, point_line_ = 0;
  char separator_ = '\0';
  std::string_view last_comment_;
};

void append_utf8(std::string& out, unsigned code) {
  const auto add = [&](unsigned byte) { out += static_cast<char>(byte); };
  if (code < 0x80) {
    add(code);
  } else if (code < 0x800) {
    add(0xC0U | (code >> 6U));
    add(0x80U | (code & 0x3FU));
  } else {
    add(0xE0U | (code >> 12U));
    add(0x80U | ((code >> 6U) & 0x3FU));
    add(0x80U | (code & 0x3FU));
  }
}

}  // namespace

std::string read_csv_text(const std::filesystem::path& path) {
  std::string text = read_text(path);
  if (text.starts_with(utf8_mark)) text.erase(0, utf8_mark.size());
  const bool little = text.starts_with("\xFF\xFE"), big = text.starts_with("\xFE\xFF");
  if (!little && !big) return text;
  std::string out;
  for (std::size_t i = 2; i + 1 < text.size(); i += 2) {
    const auto byte = [&](std::size_t at) { return static_cast<unsigned>(static_cast<unsigned char>(text[at])); };
    append_utf8(out, little ? byte(i) + 256U * byte(i + 1) : 256U * byte(i) + byte(i + 1));
  }
  return out;
}

std::string CsvTable::place(std::size_t line, std::size_t column) {
  return "line " + std::to_string(line) + ", column " + std::to_string(column + 1);
}

void CsvTable::fail(std::size_t line, std::size_t column, std::string problem, std::string remedy) const {
  throw InputError({.kind = ErrorKind::data,
                    .file = file,
                    .place = place(line, column),
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

char csv_separator(std::string_view line) {
  for (const char separator : {';', '\t', ','}) {
    if (line.find(separator) != std::string_view::npos) return separator;
  }
  return '\0';
}

CsvTable read_csv_table(const std::filesystem::path& path) { return CsvReader(path).read(read_csv_text(path)); }

}  // namespace jointid::frf

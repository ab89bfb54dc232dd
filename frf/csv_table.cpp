#include "frf/csv_table.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <utility>

#include "frf/error.hpp"

namespace jointid::frf {
namespace {

std::string read_text(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (in.bad() || !in.is_open()) {
    throw InputError({.kind = ErrorKind::data,
                      .file = path.string(),
                      .place = {},
                      .problem = std::string("cannot be read: ") + std::strerror(errno),
                      .remedy = {}});
  }
  return text;
}

/// Without blanks around it and, for column names, without quotes.
std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '"'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

/// Takes the part of `rest` before `end` off it, and `end` itself.
std::string_view take_until(std::string_view& rest, char end) {
  const std::size_t at = std::min(rest.find(end), rest.size());
  const std::string_view part = rest.substr(0, at);
  rest.remove_prefix(std::min(at + 1, rest.size()));
  return part;
}

std::vector<std::string_view> split(std::string_view line, char separator) {
  std::vector<std::string_view> parts;
  const auto count = static_cast<std::size_t>(std::count(line.begin(), line.end(), separator)) + 1;
  for (std::size_t i = 0; i < count; ++i) parts.push_back(trimmed(take_until(line, separator)));
  return parts;
}

/// A finite number, or NaN for an empty cell or one that says NaN; false for anything else.
bool parse_cell(std::string_view cell, bool decimal_comma, double& value) {
  value = std::numeric_limits<double>::quiet_NaN();
  if (cell.empty()) return true;
  std::string text(cell);
  if (decimal_comma) std::ranges::replace(text, ',', '.');
  const char* first = text.c_str() + (text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0);
  const char* last = text.c_str() + text.size();
  const auto [end, error] = std::from_chars(first, last, value);
  return error == std::errc() && end == last && !std::isinf(value);
}

/// Takes `# key = value`; any other comment is only that.
void read_comment(std::string_view line, CsvTable& table) {
  line.remove_prefix(1);
  if (line.find('=') == std::string_view::npos) return;
  const std::string key(trimmed(take_until(line, '=')));
  table.keys[key] = trimmed(line);
}

/// Any other text with a comma may get here.
void require_frequency(const CsvTable& table) {
  if (table.columns[0] == csv_frequency_column) return;
  table.fail(table.header_line, 0, "the first column is '" + table.columns[0] + "', so it is no table of FRFs",
             "begin the header row with frequency_hz, or give jointid-frf HDF5, UFF or MATLAB");
}

void read_row(std::string_view line, std::size_t number, char separator, CsvTable& table) {
  const std::vector<std::string_view> cells = split(line, separator);
  if (cells.size() != table.columns.size()) {
    table.fail(number, std::min(cells.size(), table.columns.size()) - 1,
               "the line has " + std::to_string(cells.size()) + " cells and the header " +
                   std::to_string(table.columns.size()),
               "leave cells empty where nothing was measured");
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    double value = 0.0;
    if (!parse_cell(cells[i], separator == ';', value)) {
      table.fail(number, i, "'" + std::string(cells[i]) + "' is not a number",
                 "leave the cell empty where nothing was measured");
    }
    table.cells.push_back(value);
  }
  table.lines.push_back(number);
}

}  // namespace

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

CsvTable read_csv_table(const std::filesystem::path& path) {
  const std::string text = read_text(path);
  CsvTable table;
  table.file = path.string();
  std::string_view rest = text;
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
  char separator = '\0';
  for (std::size_t number = 1; !rest.empty(); ++number) {
    const std::string_view line = take_until(rest, '\n');
    if (trimmed(line).empty()) continue;
    if (trimmed(line).front() == '#') {
      read_comment(trimmed(line), table);
    } else if (table.columns.empty()) {
      separator = csv_separator(line);
      table.header_line = number;
      for (const std::string_view name : split(line, separator)) table.columns.emplace_back(name);
      require_frequency(table);
    } else {
      read_row(line, number, separator, table);
    }
  }
  return table;
}

}  // namespace jointid::frf

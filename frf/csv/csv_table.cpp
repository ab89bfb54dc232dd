#include "frf/csv/csv_table.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "frf/text/number_text.hpp"

namespace jointid::frf {
namespace {

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

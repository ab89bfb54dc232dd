#include "frf/file/column_titles.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "frf/csv/csv_titles.hpp"
#include "frf/text/label_text.hpp"
#include "frf/text/number_text.hpp"

namespace jointid::frf {
namespace {

char separator_of(std::string_view line) {
  const char separator = csv_separator(trimmed(line));
  return separator == '\0' ? ' ' : separator;
}

bool is_number(std::string_view cell, const DecimalMark& mark) {
  double value = 0.0;
  return parse_cell(cell, mark.may_be_comma(), value);
}

}  // namespace

bool is_comment(std::string_view text) { return text.empty() || text.front() == '#' || text.front() == '%'; }

bool ColumnTitles::begins_with(std::string_view line, const std::string& place) {
  const std::string_view text = trimmed(line);
  if (is_comment(text) || take_separator(text)) return false;
  if (empty()) return !take_names(line, place);
  return !take_units(line);
}

bool ColumnTitles::take_separator(std::string_view text) {
  if (!empty() || separator_ != '\0' || text.size() != 5) return false;
  if (!text.starts_with("sep=") && !text.starts_with("SEP=") && !text.starts_with("Sep=")) return false;
  separator_ = text.back();
  return true;
}

bool ColumnTitles::take_names(std::string_view line, const std::string& place) {
  if (separator_ == '\0') separator_ = separator_of(line);
  const std::vector<std::string_view> cells = split(line, separator_);
  if (cells.size() > most_columns) {
    throw InputError(
        {ErrorKind::data, columns_.file, place,
         std::to_string(cells.size()) + " columns are more than the " + std::to_string(most_columns) + " that are read",
         "export fewer channels, or in several files; are rows and columns exchanged?"});
  }
  const DecimalMark mark(separator_);
  named_ = !std::ranges::all_of(cells, [&](std::string_view cell) { return is_number(cell, mark); });
  for (std::size_t i = 0; i < cells.size(); ++i)
    columns_.columns.push_back(named_ ? titled_column(cells[i]) : NumberColumn{std::to_string(i + 1), {}, {}});
  return named_;
}

bool ColumnTitles::take_units(std::string_view line) {
  if (!named_ || has_units_) return false;
  const std::vector<std::string_view> cells = split(line, separator_);
  if (cells.size() != columns_.columns.size()) return false;
  const DecimalMark mark(separator_);
  bool any = false;
  for (const std::string_view cell : cells) {
    if (cell.empty()) continue;
    if (is_number(cell, mark)) return false;
    any = true;
  }
  if (!any || std::ranges::any_of(columns_.columns, [](const NumberColumn& column) { return !column.unit.empty(); }))
    return false;
  for (std::size_t i = 0; i < cells.size(); ++i) columns_.columns[i].unit = without_brackets(cells[i]);
  has_units_ = true;
  return true;
}

bool DecimalMark::fits(std::string_view line) {
  if (!may_be_comma_) return true;
  points_ = points_ || line.find('.') != std::string_view::npos;
  commas_ = commas_ || line.find(',') != std::string_view::npos;
  return !(points_ && commas_);
}

}  // namespace jointid::frf

#include "frf/file/column_titles.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>

#include "base/error.hpp"
#include "frf/csv/csv_titles.hpp"
#include "frf/file/column_units.hpp"
#include "frf/file/number_cell.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/text/label_text.hpp"
#include "frf/text/number_text.hpp"
#include "frf/text/proposed_dof.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

char separator_of(std::string_view line) {
  const char separator = csv_separator(trimmed(line));
  return separator == '\0' ? ' ' : separator;
}

bool is_number(std::string_view cell, const DecimalMark& mark) {
  double value = 0.0;
  return read_number_cell(cell, mark.may_be_comma(), value).has_value();
}

/// Whether a line may be one of units: "(ms)", "s;N", "[g]".
bool are_units(const std::vector<std::string_view>& cells) {
  return std::ranges::all_of(cells, [](std::string_view cell) {
    const std::string_view label = without_brackets(cell);
    return label != cell || states_no_unit(label) || parse_unit(label) || !not_a_unit(label).empty();
  });
}

bool has_numbers(std::string_view line, char separator) {
  const DecimalMark mark(separator);
  return std::ranges::any_of(table_cells(line, separator),
                             [&](std::string_view cell) { return !cell.empty() && is_number(cell, mark); });
}

/// "Time [s]": names with units.
bool have_units(const std::vector<std::string_view>& cells) {
  return std::ranges::any_of(cells, [](std::string_view cell) {
    const NumberColumn column = titled_column(cell);
    return !column.unit.empty() && !column.name.empty();
  });
}

/// Whether the first title is of nodes.
bool is_of_nodes(std::string_view titles, char separator) { return is_name_of_nodes(table_cells(titles, separator).front()); }

/// "PART-1-1.21".
bool ends_in_number(std::string_view cell) {
  return !cell.empty() && std::isalpha(static_cast<unsigned char>(cell.front())) != 0 &&
         std::isdigit(static_cast<unsigned char>(cell.back())) != 0;
}

}  // namespace

bool is_name_of_nodes(std::string_view title) {
  const std::string name = lower_case(title);
  return std::ranges::any_of(std::to_array<std::string_view>({"node", "point", "label", "knoten", "punkt", "grid"}),
                             [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

std::string remedy_of_text(std::string_view cell) {
  const std::string_view direction = cell.substr(std::min(cell.find_first_not_of("+-"), cell.size()));
  const bool dof = cell.find_first_of("XYZxyz") != std::string_view::npos && !proposed_dof(cell).empty();
  if (dof || (direction.size() == 1 && std::string_view("XYZ").find(direction) != std::string_view::npos))
    return "of a table of nodes give each node one row, with its number in place of its DOFs: node, x, y, z";
  const bool plain = cell.find_first_not_of("0123456789:.,-/TZ+ ") == std::string_view::npos;
  const bool clock =
      plain && cell.find(':') != std::string_view::npos && std::isdigit(static_cast<unsigned char>(cell.front())) != 0;
  return clock ? "write times in s, e.g. time [s], or leave the column out and give the samples per second by --rate"
               : "begin lines that are no numbers with #";
}

std::vector<std::string_view> table_cells(std::string_view line, char separator) {
  return separator == ' ' ? split(line, separator) : csv_cells(line, separator);
}

bool is_comment(std::string_view text) { return text.empty() || text.front() == '#' || text.front() == '%'; }

bool ColumnTitles::begins_with(std::string_view line, const std::string& place) {
  constexpr std::size_t most_texts = 4;
  const std::string_view text = trimmed(line);
  if (take_separator(text)) return false;
  if (!is_of_numbers(line)) remember(text, place);
  if (is_comment(text)) return false;
  if (is_of_numbers(line)) {
    settle(line);
    take_unit_suffixes(columns_);
    if (empty()) {
      const std::size_t count = table_cells(line, separator_).size();
      require_few(count, place);
      for (std::size_t i = 0; i < count; ++i) columns_.columns.push_back({std::to_string(i + 1), {}, {}});
    }
    return true;
  }
  if (texts_.empty()) require_few(table_cells(line, separator_in(line)).size(), place);
  if (texts_.size() == most_texts) texts_.erase(texts_.begin() + 2);
  texts_.push_back({std::string(line), place});
  ++texts_seen_;
  return false;
}

void ColumnTitles::end() {
  if (!empty() || texts_.empty()) return;
  if (texts_seen_ > 2 || (texts_seen_ == 2 && has_numbers(texts_.back().text, separator_in(texts_.back().text))))
    refuse(texts_[1], {});
  take_names(texts_.front());
  if (texts_.size() > 1) take_units(texts_.back().text);
  take_unit_suffixes(columns_);
}

/// Lines that may state what the titles do not.
void ColumnTitles::remember(std::string_view text, const std::string& place) {
  constexpr std::size_t most = 100, longest = 200;
  if (!text.empty() && text.size() <= longest && columns_.remarks.size() < most)
    columns_.remarks.push_back({place, std::string(text)});
}

char ColumnTitles::separator_in(std::string_view line) const { return separator_ != '\0' ? separator_ : separator_of(line); }

/// By its first cell; a first line of all lines that is not all numbers is one of names, whatever that cell is.
bool ColumnTitles::is_of_numbers(std::string_view line) const {
  const char separator = separator_in(line);
  const DecimalMark mark(separator);
  const std::vector<std::string_view> cells = table_cells(line, separator);
  const auto number = [&](std::string_view cell) { return is_number(cell, mark); };
  const bool all = std::ranges::all_of(cells, number);
  if (texts_.empty()) return all;
  const auto count = std::ranges::count_if(cells, [&](std::string_view cell) { return !cell.empty() && number(cell); });
  const bool sentence = separator == ' ' && cells.size() > 1 && count == 1;  // "3 channels"
  const bool named = cells.size() > 2 && count + 1 == std::ssize(cells) && is_of_nodes(texts_.back().text, separator) &&
                     ends_in_number(cells.front());
  return named || (count > 0 && !sentence && number(cells.front()) && (all || !cells.front().empty()));
}

void ColumnTitles::settle(std::string_view numbers) {
  const auto fits = [&](const TextLine& line) {
    const char separator = separator_in(line.text);
    return table_cells(line.text, separator).size() == table_cells(numbers, separator).size();
  };
  if (texts_.empty()) {
    separator_ = separator_in(numbers);
    return;
  }
  const auto last = std::ranges::find_if(texts_.rbegin(), texts_.rend(), fits);
  if (last == texts_.rend()) return take_names(texts_.back());
  const auto above = last + 1;
  if (above == texts_.rend() || !fits(*above)) return take_names(*last);
  const std::vector<std::string_view> cells = table_cells(last->text, separator_in(last->text));
  if (has_numbers(last->text, separator_in(last->text))) refuse(*last, {});
  const bool units = are_units(cells) || (texts_seen_ == 2 && !have_units(cells));
  take_names(units ? *above : *last);
  const bool stated = std::ranges::any_of(columns_.columns, [](const NumberColumn& column) { return !column.unit.empty(); });
  if (units && stated) refuse(*last, "; the titles above have units already");
  if (units) take_units(last->text);
}

void ColumnTitles::refuse(const TextLine& line, const std::string& why) const {
  const std::string cell(table_cells(line.text, separator_in(line.text)).front().substr(0, 40));
  throw InputError(
      {ErrorKind::data, columns_.file, line.place + ", column 1", "'" + cell + "' is not a number", remedy_of_text(cell) + why});
}

void ColumnTitles::require_few(std::size_t columns, const std::string& place) const {
  if (columns <= most_columns) return;
  throw InputError({ErrorKind::data, columns_.file, place,
                    std::to_string(columns) + " columns are more than the " + std::to_string(most_columns) + " that are read",
                    "export fewer channels, or in several files; are rows and columns exchanged?"});
}

bool ColumnTitles::take_separator(std::string_view text) {
  if (!texts_.empty() || separator_ != '\0' || text.size() != 5) return false;  // quotes are trimmed off
  if (!text.starts_with("sep=") && !text.starts_with("SEP=") && !text.starts_with("Sep=")) return false;
  separator_ = text.back();
  return true;
}

void ColumnTitles::take_names(const TextLine& line) {
  separator_ = separator_in(line.text);
  std::erase_if(columns_.remarks, [&](const TableRemark& remark) { return remark.place == line.place; });
  const std::vector<std::string_view> cells = table_cells(line.text, separator_);
  require_few(cells.size(), line.place);
  for (const std::string_view cell : cells) columns_.columns.push_back(titled_column(cell));
}

void ColumnTitles::take_units(std::string_view line) {
  std::erase_if(columns_.remarks, [&](const TableRemark& remark) { return remark.text == trimmed(line); });
  const std::vector<std::string_view> cells = table_cells(line, separator_);
  for (std::size_t i = 0; i < std::min(cells.size(), columns_.columns.size()); ++i)
    if (!cells[i].empty()) columns_.columns[i].unit = without_brackets(cells[i]);
}

bool DecimalMark::fits(std::string_view line) {
  if (!may_be_comma_) return true;
  points_ = points_ || line.find('.') != std::string_view::npos;
  commas_ = commas_ || line.find(',') != std::string_view::npos;
  return !(points_ && commas_);
}

}  // namespace jointid::frf

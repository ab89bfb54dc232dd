#include "frf/csv/csv_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/stop_scope.hpp"
#include "frf/csv/csv_functions.hpp"
#include "frf/csv/csv_remarks.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/set/units.hpp"
#include "frf/text/complex_text.hpp"
#include "frf/text/footer.hpp"
#include "frf/text/label_text.hpp"
#include "frf/text/located.hpp"
#include "frf/text/number_text.hpp"
#include "frf/text/remarks.hpp"
#include "frf/text/special_number.hpp"
#include "frf/text/thousands.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

/// Reads a table line by line.
class CsvReader {
 public:
  CsvReader(const std::string& file, const CsvGiven& given) : given_(given) { table_.file = file; }

  CsvTable read(std::string_view rest) {
    take_separator(rest.substr(0, rest.find('\n')));
    const bool cut = ends_in_a_cut_number(rest);
    header_ = find_csv_header(rest, separator_);
    for (line_ = 1; !rest.empty(); ++line_) {
      stop_point();
      const std::string_view line = take_until(rest, '\n'), text = trimmed(line);
      if (!text.empty() && !(line_ == 1 && separator_ != '\0')) take(line, text);
    }
    if (table_.columns.empty()) return std::move(table_);
    if (cut) table_.fail(line_ - 1, table_.columns.size() - 1, cut_number, whole_file);
    for (const CsvNote& footer : footers_) take_footer(footer);
    require_clear_angles();
    require_clear_commas();
    read_csv_notes(notes_, table_.file, table_.units, given_.unit, table_.keys);
    require_axis();
    table_.hz_per_unit = hz_per_unit();
    judge_remarks();
    split_complex();
    return std::move(table_);
  }

 private:
  /// `sep=;`, which Excel writes and hides.
  void take_separator(std::string_view line) {
    const std::string_view text = trimmed(line);
    if (text.size() < 4 || lower_case(text.substr(0, 4)) != "sep=") return;
    separator_ = text.size() > 4 ? text[4] : '\t';  // a tab was trimmed
  }

  void take(std::string_view line, std::string_view text) {
    const bool comment = text.front() == '#' || text.front() == '%';
    if (header_ && line_ == header_->line) {
      read_header(comment ? text.substr(1) : line);
    } else if (comment && !begins_without_value(text)) {
      read_csv_key(text, table_.file, line_, given_.unit, table_.keys);
      remarks_.push_back({line_, std::string(trimmed(text.substr(1)))});
    } else if (header_ && line_ < header_->line) {
      notes_.push_back(csv_note(text, line_, header_->separator));
      remarks_.push_back({line_, std::string(text)});
      above_ = line;
    } else if (table_.columns.empty()) {
      read_header(line);
    } else if (table_.lines.empty() && table_.units_line == table_.header_line && is_parts(line)) {
      read_parts(line);
    } else if (table_.lines.empty() && (is_heading_of_units(line) || are_types(csv_cells(line, separator_)))) {
      return;
    } else if (table_.lines.empty() && is_description(line)) {
      notes_.push_back(csv_note(text, line_, separator_));
      remarks_.push_back({line_, std::string(text)});
    } else if (table_.lines.empty() && table_.units_line == table_.header_line && is_units(line)) {
      read_units(line);
    } else {
      take_row(line, text);
    }
  }

  /// A row, or a line of words below them; the same titles may stand above each page.
  void take_row(std::string_view line, std::string_view text) {
    const std::vector<std::string_view> cells = csv_cells(line, separator_);
    if (std::ranges::all_of(cells, [](std::string_view cell) { return cell.empty(); })) return;
    const bool rows = !table_.lines.empty();
    if (rows && (text == titles_text_ || text == units_text_)) return;
    if (rows && is_footer(cells, table_.columns.size())) {
      footers_.push_back(csv_note(text, line_, separator_));
      if (!is_page_mark(text) && first_words_.empty()) first_words_ = text, words_line_ = line_;
      return;
    }
    if (!first_words_.empty())
      table_.fail(words_line_, 0, "'" + shown_label(first_words_) + "' is between lines of numbers",
                  "begin lines that are no rows of the table with #, or remove what does not belong to it");
    read_row(line);
  }

  void take_footer(const CsvNote& footer) {
    notes_.push_back(footer);
    const std::string words = footer.key.empty() ? footer.value : footer.key + ": " + footer.value;
    if (warns_of_data(words))
      table_.doubts.push_back("line " + std::to_string(footer.line) + " below the table states '" + shown_label(words) + "'");
  }

  void judge_remarks() {
    for (const CsvRemark& remark : remarks_) {
      if (std::string told = factor_not_applied(remark); !told.empty()) table_.doubts.push_back(std::move(told));
    }
    if (given_.unit) return;
    const auto in_titles =
        std::ranges::find_if(table_.units, [](const std::string& unit) { return quantity_of_unit(unit).has_value(); });
    const auto key = table_.keys.find("unit");
    const bool stated = in_titles != table_.units.end() || key != table_.keys.end();
    const auto add = [&](std::string told) {
      if (!told.empty()) table_.doubts.push_back(std::move(told));
    };
    if (!stated) {
      for (const CsvRemark& remark : remarks_) add(sensitivity_stated(remark));
      return require_no_unit_in_remarks(remarks_, table_.file);
    }
    const std::string& unit = in_titles != table_.units.end() ? *in_titles : key->second;
    for (const CsvRemark& remark : remarks_) add(other_unit_stated(remark, unit, table_.hz_per_unit));
  }

  /// Parts alone in a second row of titles, under the names of FRFs: "", "Real", "Imaginary".
  bool is_parts(std::string_view line) const {
    const std::vector<std::string_view> cells = csv_cells(line, separator_);
    return cells.size() > 2 && cells.size() >= table_.columns.size() && table_.places.front() == 0 && cells[0].empty() &&
           std::all_of(cells.begin() + 1, cells.end(), [](std::string_view cell) { return is_csv_part(cell); });
  }

  /// Behind the names above them, each of which stands above its first part.
  void read_parts(std::string_view line) {
    const std::vector<std::string_view> cells = csv_cells(line, separator_);
    std::string name;
    for (std::size_t i = 1; i < cells.size(); ++i) {
      if (i >= table_.columns.size()) table_.columns.emplace_back(), table_.units.emplace_back(), table_.places.push_back(i);
      if (!table_.columns[i].empty()) name = table_.columns[i];
      table_.columns[i] = (name.empty() ? "" : name + " ") + std::string(cells[i]);
    }
  }

  /// Units alone in the row above the titles: "Hz", "g/N", "g/N".
  void read_units_above() {
    if (above_.empty() || csv_cells(above_, separator_).size() < table_.columns.size()) return;
    const std::vector<std::string_view> cells = cells_of(above_);
    const auto is_unit = [](std::string_view cell) { return cell.empty() || parse_unit(without_brackets(cell)).has_value(); };
    if (cells.size() != table_.columns.size() || !std::ranges::all_of(cells, is_unit)) return;
    const auto is_frf_unit = [](std::string_view cell) { return quantity_of_unit(without_brackets(cell)).has_value(); };
    const bool units = cells[0].empty() ? std::ranges::any_of(cells, is_frf_unit)
                                        : parse_unit(without_brackets(cells[0]))->same_dimension({1.0, 0, -1, 0});
    if (units && std::ranges::all_of(table_.units, [](const std::string& unit) { return unit.empty(); })) read_units(above_);
  }

  /// "#DIV/0!", which is no comment, in the first cell of a row.
  bool begins_without_value(std::string_view text) const {
    return !table_.columns.empty() && text.front() == '#' && states_no_value(csv_cells(text, separator_).front());
  }

  void read_header(std::string_view line) {
    if (separator_ == '\0') separator_ = header_ ? header_->separator : csv_separator(line);
    table_.header_line = table_.units_line = line_;
    titles_text_ = trimmed(line);
    std::vector<std::string_view> cells = csv_cells(line, separator_);
    while (cells.size() > 2 && cells.back().empty()) cells.pop_back();
    const std::size_t index = header_ ? header_->index : 0;
    require_column_of_frequencies(cells);
    for (std::size_t i = index; i < cells.size(); ++i) {
      if (i > index) require_no_factor(cells[i], i);
      CsvTitle title = csv_title(cells[i]);
      table_.columns.push_back(std::move(title.title));
      table_.units.push_back(std::move(title.unit));
      table_.places.push_back(i);
    }
    pair_parts(table_.columns);
    take_frequency_title(cells[index]);
    read_units_above();
  }

  /// "Frequency [Hz]", then nothing but numbers: rows and columns are exchanged.
  void require_column_of_frequencies(const std::vector<std::string_view>& cells) const {
    double value = 0.0;
    const bool row = cells.size() > 2 && frequency_title(cells[0]) &&
                     std::all_of(cells.begin() + 1, cells.end(), [&](auto cell) { return !cell.empty() && parse(cell, value); });
    if (row)
      table_.fail(line_, 0, "the frequencies are in a row", "exchange rows and columns, so that they are in the first column");
  }

  /// The table has no place for it beside the unit.
  void require_no_factor(std::string_view cell, std::size_t column) const {
    if (states_conjugates(cell))
      table_.fail(table_.header_line, column, "'" + shown_label(cell) + "' states conjugates of FRFs of exp(+iωt)",
                  "export the FRFs for exp(+iωt)");
    if (!factor_in_title(cell)) return;
    table_.fail(table_.header_line, column, "'" + shown_label(cell) + "' states a factor, which is not applied",
                "export the numbers themselves, or state it by the unit, e.g. [mm/(s^2*N)], and not in the title");
  }

  /// Any other text with a comma may get here.
  void take_frequency_title(std::string_view cell) {
    if (auto title = frequency_title(cell)) {
      table_.columns[0] = std::move(title->title);
      table_.units[0] = std::move(title->unit);
    } else if (given_.frequency_unit.empty() && !(header_ && header_->any_axis)) {
      refuse_axis(cell);
    }
  }

  [[noreturn]] void refuse_axis(std::string_view name) const {
    if (name.size() > 1 && name.front() == '\'' && name.back() == '\'')
      table_.fail(table_.header_line, 0, "cells are in single quotes, " + std::string(name),
                  "remove these, or write double quotes");
    table_.fail(table_.header_line, 0, "the first column is '" + std::string(name) + "', so it is no table of FRFs",
                "begin the header row with frequency_hz, or give jointid-frf HDF5, UFF or MATLAB; does it hold frequencies? Give "
                "their unit: --frequency-unit Hz, in a scene frequency_unit");
  }

  /// A first column that is no title of frequencies, "X", holds them where its unit does, in a row or, of a name for any axis, in
  /// a free line.
  void require_axis() const {
    if (!header_ || !header_->any_axis || !given_.frequency_unit.empty()) return;
    constexpr std::array<std::string_view, 9> any = {"",         "x",        "x-axis", "x axis", "x value",
                                                     "x values", "abscissa", "linear", "x-achse"};
    const std::string &name = table_.columns[0], &unit = table_.units[0];
    const bool by_row = frequency_title((name.empty() ? "axis" : name) + " [" + unit + "]").has_value();
    const bool by_line = table_.keys.contains("frequency_unit") && std::ranges::find(any, lower_case(name)) != any.end();
    if (unit.empty() ? !by_line : !by_row) refuse_axis(unit.empty() ? name : name + " [" + unit + "]");
  }

  double hz_per_unit() const {
    if (!given_.frequency_unit.empty()) return hertz_per(given_.frequency_unit).value_or(1.0);
    const std::string& own = table_.units[0];
    const auto key = table_.keys.find("frequency_unit");
    const auto parse = [&](const std::string& label, const std::string& place) {
      return located(table_.file, place, [&] { return hertz_per(label).value_or(1.0); });
    };
    const double of_column = parse(own, table_.place(table_.units_line, 0));
    if (key == table_.keys.end()) return of_column;
    const double of_key = parse(key->second, "# frequency_unit");
    if (!own.empty() && of_key != of_column)
      table_.fail(table_.units_line, 0, "the unit '" + own + "' is not that of # frequency_unit, '" + key->second + "'",
                  "remove the wrong one, or give --frequency-unit, in a scene frequency_unit");
    return of_key;
  }

  bool may_be_comma(std::string_view cell) const {
    return separator_ != ',' || cell.find(',') != std::string_view::npos;
  }  // in quotes

  bool parse(std::string_view cell, double& value) const { return parse_cell(cell, may_be_comma(cell), value); }

  /// The cells of a line without those of columns that are passed over.
  std::vector<std::string_view> cells_of(std::string_view line) const {
    std::vector<std::string_view> cells = csv_cells(line, separator_);
    const std::size_t first = table_.places.front(), count = first + table_.columns.size();
    while (cells.size() > count && cells.back().empty()) cells.pop_back();
    cells.erase(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(std::min(first, cells.size())));
    return cells;
  }

  /// "Units:" alone in a line, as analysers write it above the row of units.
  bool is_heading_of_units(std::string_view line) const {
    const std::vector<std::string_view> cells = csv_cells(line, separator_);
    const std::string word = lower_case(cells.front());
    return (word == "units:" || word == "units") &&
           std::all_of(cells.begin() + 1, cells.end(), [](auto cell) { return cell.empty(); });
  }

  /// A row of words under the titles, "hammer test": several in one cell at least, and no unit or what may be meant as one.
  bool is_description(std::string_view line) const {
    if (!is_units(line)) return false;
    const auto may_be_unit = [](std::string_view cell) {
      const std::string_view label = without_brackets(cell);
      const bool ratio = label.find('/') != std::string_view::npos || lower_case(label).find(" per ") != std::string::npos;
      return ratio || parse_unit(label) || !unit_hint(label).empty() || lower_case(label).starts_with("db") || is_degrees(label);
    };
    const std::vector<std::string_view> cells = cells_of(line);
    return std::ranges::none_of(cells, may_be_unit) &&
           std::ranges::any_of(cells, [](std::string_view cell) { return cell.find(' ') != std::string_view::npos; });
  }

  /// A row without a number, under the titles.
  bool is_units(std::string_view line) const {
    const std::vector<std::string_view> cells = cells_of(line);
    if (cells.size() != table_.columns.size()) return false;
    const auto empty = [](std::string_view cell) { return cell.empty(); };
    return !std::ranges::all_of(cells, empty) && std::ranges::none_of(cells, [&](std::string_view cell) {
      double value = 0.0;
      return !cell.empty() && (parse(cell, value) || parse_complex(cell, may_be_comma(cell)) ||
                               parse_polar(cell, may_be_comma(cell)) || without_thousands(cell));
    });
  }

  void read_units(std::string_view line) {
    const std::vector<std::string_view> cells = cells_of(line);
    table_.units_line = line_;
    units_text_ = trimmed(line);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string unit = as_ratio(std::string(without_brackets(cells[i])));
      if (unit.empty()) continue;
      if (!table_.units[i].empty() && table_.units[i] != unit)
        table_.fail(line_, i, "the unit is '" + unit + "' here and '" + table_.units[i] + "' in the title",
                    "remove the wrong one");
      table_.units[i] = unit;
    }
  }

  void read_row(std::string_view line) {
    const std::vector<std::string_view> cells = cells_of(line);
    if (cells.size() != table_.columns.size()) {
      table_.fail(
          line_, std::min(cells.size(), table_.columns.size()) - (cells.empty() ? 0 : 1),
          "the line has " + std::to_string(cells.size()) + " cells and the header " + std::to_string(table_.columns.size()),
          "leave cells empty where nothing was measured");
    }
    for (std::size_t i = 0; i < cells.size(); ++i) read_cell(cells[i], i);
    table_.lines.push_back(line_);
  }

  void read_cell(std::string_view cell, std::size_t column) {
    double value = 0.0;
    if (parse(cell, value)) {
      require_one_decimal_sign(cell, column);
    } else if (const auto plain = without_thousands(cell); plain && parse_cell(*plain, false, value)) {
      require_one_decimal_sign(cell.find_last_of(".,") < cell.size() ? cell.substr(cell.find_last_of(".,")) : cell, column);
    } else if (states_no_value(cell)) {
      value = std::numeric_limits<double>::quiet_NaN();
    } else if (column == 0 || !read_complex(cell, column, value)) {
      table_.fail(line_, column, "'" + std::string(cell) + "' is not a number",
                  column == 0 ? "begin lines that are no rows of the table with #"
                              : "leave the cell empty where nothing was measured; complex numbers are 1.2+3.4j or 1.2∠-45°");
    }
    if (const auto known = imaginary_.find(column); known != imaginary_.end()) known->second.resize(table_.rows() + 1, 0.0);
    table_.cells.push_back(value);
  }

  /// Keeps the imaginary part; real numbers above and below have none.
  bool read_complex(std::string_view cell, std::size_t column, double& real) {
    auto value = parse_complex(cell, may_be_comma(cell));
    if (!value) value = polar_value(cell, column);
    if (!value) return false;
    real = value->real();
    std::vector<double>& parts = imaginary_[column];
    parts.resize(table_.rows(), 0.0);
    parts.push_back(value->imag());
    return true;
  }

  std::optional<Complex> polar_value(std::string_view cell, std::size_t column) {
    const auto polar = parse_polar(cell, may_be_comma(cell));
    if (!polar) return std::nullopt;
    if (polar->unit == AngleUnit::unstated) {
      if (angle_line_ == 0) angle_line_ = line_, angle_column_ = column;
      cis_ = cis_ || polar->cis;
      largest_angle_ = std::max(largest_angle_, std::abs(polar->angle));
    }
    return polar->value();
  }

  /// "1.2∠0.7" without the unit of its angle. That of the function cis is in radians, which reach π near a mode.
  void require_clear_angles() const {
    constexpr double surely_degrees = 30.0, surely_radians = 3.0, half_turn = std::numbers::pi * (1.0 + 1e-6);
    const bool clear = cis_ ? largest_angle_ >= surely_radians && largest_angle_ <= half_turn : largest_angle_ > surely_degrees;
    if (angle_line_ == 0 || clear) return;
    table_.fail(angle_line_, angle_column_, "an angle does not state whether it is in degrees or radians",
                "write its unit behind it: 1.2∠-45° or 1.2∠-0.785rad");
  }

  /// 1,000 beside 990 may be one or a thousand; programs that write decimals write them in all numbers.
  void require_clear_commas() const {
    if (comma_line_ == 0 || surely_decimal_ || !whole_numbers_) return;
    table_.fail(comma_line_, 0, "all commas are before three digits: they may be decimal signs or marks of thousands",
                "export the numbers without marks of thousands, or with decimal points");
  }

  /// 1,234 beside 5.6 may be a thousand and more.
  void require_one_decimal_sign(std::string_view cell, std::size_t column) {
    const bool comma = cell.find(',') != std::string_view::npos, point = cell.find('.') != std::string_view::npos;
    if (comma) comma_line_ = line_;
    if (comma && !may_be_thousands(cell)) surely_decimal_ = true;
    if (point) point_line_ = line_;
    if (!comma && !point && !cell.empty()) whole_numbers_ = true;
    if ((!comma && !point) || comma_line_ == 0 || point_line_ == 0) return;
    table_.fail(line_, column,
                "'" + std::string(cell) + "' and line " + std::to_string(comma ? point_line_ : comma_line_) +
                    " have different decimal signs, comma and point",
                "write all numbers with one of them and without marks of thousands");
  }

  /// Columns of complex numbers into their real and imaginary parts.
  void split_complex() {
    if (imaginary_.empty()) return;
    CsvTable split;
    std::vector<std::pair<std::size_t, bool>> from;  // column, whether its imaginary part
    for (std::size_t c = 0; c < table_.columns.size(); ++c) {
      const bool complex = imaginary_.contains(c);
      if (complex) require_whole(c);
      for (const char* part : complex ? std::vector{" re", " im"} : std::vector{""}) {
        split.columns.push_back(table_.columns[c] + part);
        split.units.push_back(table_.units[c]);
        split.places.push_back(table_.places[c]);
        from.emplace_back(c, std::string_view(part) == " im");
      }
    }
    split.cells.reserve(table_.rows() * from.size());
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      for (const auto& [c, imaginary] : from) {
        const double real = table_.cell(row, c);
        split.cells.push_back(imaginary && !std::isnan(real) ? imaginary_[c][row] : real);
      }
    }
    table_.columns = std::move(split.columns), table_.units = std::move(split.units), table_.places = std::move(split.places);
    table_.cells = std::move(split.cells);
  }

  void require_whole(std::size_t column) const {
    const std::string& title = table_.columns[column];
    if (is_csv_part(title.substr(title.find_last_of(' ') + 1)))
      table_.fail(table_.header_line, column, "'" + title + "' names a part and holds complex numbers",
                  "leave the part out, as in 4:+Y/1:+Y, or export both parts to columns of their own");
  }

  CsvTable table_;
  const CsvGiven& given_;
  std::optional<CsvHeaderPlace> header_;
  std::vector<CsvNote> notes_;
  std::vector<CsvRemark> remarks_;
  std::string_view above_;                                ///< the free line above the titles
  std::map<std::size_t, std::vector<double>> imaginary_;  ///< by column that holds complex numbers
  std::vector<CsvNote> footers_;
  std::string titles_text_, units_text_, first_words_;
  std::size_t line_ = 0, comma_line_ = 0, point_line_ = 0, words_line_ = 0, angle_line_ = 0, angle_column_ = 0;
  double largest_angle_ = 0.0;
  bool cis_ = false;             ///< an angle without a unit is that of cis(0.7)
  bool surely_decimal_ = false;  ///< a comma
  bool whole_numbers_ = false;   ///< numbers without comma and point
  char separator_ = '\0';
};

}  // namespace

std::string CsvTable::place(std::size_t line, std::size_t column) const {
  const std::size_t of_file = column < places.size() ? places[column] : column;
  return "line " + std::to_string(line) + ", column " + std::to_string(of_file + 1);
}

void CsvTable::fail(std::size_t line, std::size_t column, std::string problem, std::string remedy) const {
  throw InputError({.kind = ErrorKind::data,
                    .file = file,
                    .place = place(line, column),
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

CsvTable read_csv_table(const std::string& file, std::string_view text, const CsvGiven& given) {
  return CsvReader(file, given).read(text);
}

}  // namespace jointid::frf

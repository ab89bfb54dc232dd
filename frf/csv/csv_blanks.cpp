#include "frf/csv/csv_blanks.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "frf/csv/csv_titles.hpp"
#include "frf/text/complex_text.hpp"
#include "frf/text/footer.hpp"
#include "frf/text/number_text.hpp"
#include "frf/text/special_number.hpp"

namespace jointid::frf {
namespace {

using Cells = std::vector<std::string_view>;

bool is_remark(std::string_view text) { return text.front() == '#' || text.front() == '%'; }

bool is_value(std::string_view cell) {
  double value = 0.0;
  return parse_cell(cell, true, value) || parse_complex(cell, true) || parse_polar(cell, true) || states_no_value(cell);
}

/// The cells of a row of numbers, of which the first is one; empty of any other line.
Cells row_of(std::string_view line) {
  double first = 0.0;
  const std::string_view text = trimmed(line);
  if (text.empty() || text.find_first_of(";\t\"") != std::string_view::npos) return {};
  Cells cells = split(text, ' ');
  const bool row = cells.size() > 1 && parse_cell(cells[0], true, first) && std::ranges::all_of(cells, is_value);
  return row ? cells : Cells{};
}

Cells lines_of(std::string_view text) {
  Cells lines;
  while (!text.empty()) lines.push_back(take_until(text, '\n'));
  return lines;
}

constexpr std::size_t most_footers = 20;

/// A line of words below the rows.
bool is_footer_line(std::string_view text) {
  return text.find_first_of(";\t\"") == std::string_view::npos && is_footer({text}, 2);
}

/// Whether the last line but comments, empty ones and lines of words is a row: most texts are no such table, and need not be cut
/// into lines.
bool ends_in_row(std::string_view text) {
  for (std::size_t footers = 0; !text.empty();) {
    const std::size_t before = text.rfind('\n'), begin = before == std::string_view::npos ? 0 : before + 1;
    const std::string_view plain = trimmed(text.substr(begin));
    const bool footer = !plain.empty() && !is_remark(plain) && is_footer_line(plain) && ++footers <= most_footers;
    if (!plain.empty() && !is_remark(plain) && !footer) return !row_of(plain).empty();
    text = text.substr(0, begin == 0 ? 0 : before);
  }
  return false;
}

/// At two blanks or more.
Cells at_wide_blanks(std::string_view text) {
  Cells cells;
  while (!(text = trimmed(text)).empty()) {
    const std::size_t end = std::min(text.find("  "), text.size());
    cells.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return cells;
}

std::string_view from_to(std::string_view first, std::string_view last) {
  return {first.data(), static_cast<std::size_t>(last.data() + last.size() - first.data())};
}

/// Words with the units in brackets behind them and, if asked for, parts with the labels beside them: "4:+Y/1:+Y re".
Cells joined(const Cells& words, bool parts) {
  Cells cells;
  bool whole = true;  // nothing more belongs to the last cell but a unit
  for (const std::string_view word : words) {
    const bool unit = !cells.empty() && (word.front() == '[' || word.front() == '(');
    const bool pair = parts && !whole && is_csv_part(word) != is_csv_part(cells.back());
    if (unit || pair) {
      cells.back() = from_to(cells.back(), word);
    } else {
      cells.push_back(word);
    }
    whole = unit || pair || cells.size() == 1;
  }
  return cells;
}

/// A line of titles or units as so many cells; empty where it cannot be cut so.
Cells titles_of(std::string_view line, std::size_t count) {
  if (const char separator = csv_separator(line); separator != '\0') {
    Cells cells = csv_cells(line, separator);
    if (cells.size() == count) return cells;
  }
  const Cells words = split(trimmed(line), ' ');
  for (Cells cells : {at_wide_blanks(line), words, joined(words, false), joined(words, true)}) {
    if (cells.size() == count) return cells;
  }
  if (words.size() + 1 == count && std::ranges::all_of(words, is_csv_part)) {  // the axis has its title elsewhere
    Cells cells = words;
    cells.insert(cells.begin(), std::string_view());
    return cells;
  }
  return {};
}

std::string with_tabs(const Cells& cells) {
  std::string text;
  for (const std::string_view cell : cells) text.append(cell).append("\t");
  if (!text.empty()) text.pop_back();
  return text;
}

class BlankTable {
 public:
  explicit BlankTable(std::string_view text) : lines_(lines_of(text)) {}

  /// Whether the last lines but those of words are rows of one length, comments and empty lines among them.
  bool is_there() {
    first_ = lines_.size();
    for (std::size_t i = lines_.size(); i-- > 0;) {
      const std::string_view plain = trimmed(lines_[i]);
      if (plain.empty() || is_remark(plain)) continue;
      if (is_footer_line(plain) && count_ == 0) continue;
      const std::size_t cells = row_of(plain).size();
      if (cells == 0 || (count_ != 0 && cells != count_)) break;
      count_ = cells, first_ = i;
      commas_ = commas_ || plain.find(',') != std::string_view::npos;
    }
    return count_ != 0 && !(commas_ && csv_separator(text_of_titles()) == ',');
  }

  std::string text() const {
    const std::size_t titles = line_of_titles();
    std::string out;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const std::string_view plain = trimmed(lines_[i]);
      if (plain.empty() || i < titles || (i != titles && is_remark(plain))) {
        out.append(lines_[i]);
      } else if (i >= first_) {
        const bool row = !row_of(plain).empty();
        out.append(row ? with_tabs(split(plain, ' ')) : std::string(plain));
      } else {
        out.append(title_text(plain));
      }
      out += '\n';
    }
    return out;
  }

 private:
  /// Above the rows: the last line that begins with a title of frequencies, else the last that is no comment.
  std::size_t line_of_titles() const {
    std::size_t other = first_;
    for (std::size_t i = first_; i-- > 0;) {
      std::string_view plain = trimmed(lines_[i]);
      if (plain.empty()) continue;
      const bool comment = is_remark(plain);
      if (comment) plain.remove_prefix(1);
      const Cells cells = titles_of(plain, count_);
      if (!cells.empty() && (frequency_title(cells[0]) || (cells.size() > 1 && frequency_title(cells[1])))) return i;
      if (!comment && other == first_) other = i;
    }
    return other;
  }

  /// Titles between commas leave it open what commas between the numbers are: "10,1 000".
  std::string_view text_of_titles() const {
    const std::size_t line = line_of_titles();
    return line < first_ ? lines_[line] : std::string_view();
  }

  std::string title_text(std::string_view plain) const {
    const std::string mark = is_remark(plain) ? std::string(plain.substr(0, 1)) : std::string();
    const std::string_view line = plain.substr(mark.size());
    const Cells cells = titles_of(line, count_);
    return mark + with_tabs(cells.empty() ? split(trimmed(line), ' ') : cells);
  }

  Cells lines_;
  std::size_t first_ = 0, count_ = 0;
  bool commas_ = false;  ///< in a row
};

}  // namespace

std::optional<std::string> tabs_for_blanks(std::string_view text) {
  if (!ends_in_row(text)) return std::nullopt;
  BlankTable table(text);
  return table.is_there() ? std::optional(table.text()) : std::nullopt;
}

}  // namespace jointid::frf

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "frf/file/columns.hpp"

namespace jointid::frf {

/// More columns than this are no table of channels.
inline constexpr std::size_t most_columns = 100'000;

/// What stands above the numbers of a table, taken line by line: comments (# or %), `sep=;` as spreadsheets write it, the names
/// of the columns with or without units, and a row of units below them ("(ms)", "s", "[N]"). The separator is the one that `sep=`
/// says, else the first of semicolon, tab and comma that stands in the line of names, else blanks. Free lines may stand above:
/// the names are the last line of as many cells as the first line of numbers has, or the one before it where that holds units.
class ColumnTitles {
 public:
  explicit ColumnTitles(std::string file) { columns_.file = std::move(file); }

  /// Whether the numbers begin with this line; else it was taken. Throws InputError at `place` for more than most_columns, and
  /// for a line of texts under names with units.
  bool begins_with(std::string_view line, const std::string& place);

  /// To be called where no line began the numbers: the texts were all. Throws InputError where they were more than names and
  /// units.
  void end();

  char separator() const { return separator_; }
  /// Without numbers; of a table without names 1, 2, … Remarks are the comments, and free lines that are neither names nor units.
  const Columns& columns() const { return columns_; }
  bool empty() const { return columns_.columns.empty(); }

 private:
  struct TextLine {
    std::string text, place;
  };

  bool take_separator(std::string_view text);
  void remember(std::string_view text, const std::string& place);
  bool is_of_numbers(std::string_view line) const;
  char separator_in(std::string_view line) const;
  /// Names by the lines of texts; `numbers` is the first line of numbers.
  void settle(std::string_view numbers);
  void take_names(const TextLine& line);
  void take_units(std::string_view line);
  [[noreturn]] void refuse(const TextLine& line, const std::string& why) const;
  void require_few(std::size_t columns, const std::string& place) const;

  Columns columns_;
  char separator_ = '\0';
  std::vector<TextLine> texts_;  ///< the first two and the last two
  std::size_t texts_seen_ = 0;
};

/// Numbers between semicolons and tabs may have decimal commas; in one table either all of them do or none.
class DecimalMark {
 public:
  explicit DecimalMark(char separator = '\0') : may_be_comma_(separator == ';' || separator == '\t') {}

  bool may_be_comma() const { return may_be_comma_; }
  /// False where a line of numbers has a comma and it, or one before, a point.
  bool fits(std::string_view line);

 private:
  bool may_be_comma_, points_ = false, commas_ = false;
};

/// What is said of a line that DecimalMark does not fit, and the remedy.
inline constexpr const char* mixed_marks = "there are decimal points and commas";
inline constexpr const char* one_mark = "write all numbers with one of them, without separators of thousands";

/// A line of no numbers above a table: empty, or a comment.
bool is_comment(std::string_view text);

/// Whether a column by this title holds names of nodes, "Node Label".
bool is_name_of_nodes(std::string_view title);

/// What to do about a cell that is no number: of a clock time, "12:00:01.5" and "2026-11-30T12:00:01", or of any other text.
std::string remedy_of_text(std::string_view cell);

/// The cells of a line: split(), separators inside quotes left out.
std::vector<std::string_view> table_cells(std::string_view line, char separator);

}  // namespace jointid::frf

#pragma once

#include <optional>
#include <string>
#include <vector>

namespace jointid::report {

enum class Align { left, right };

struct Column {
  std::string title;
  Align align = Align::right;
};

/// A plain text table: columns two blanks apart and as wide as their widest cell (in characters, not bytes), no blanks
/// at the ends of lines.
class Table {
 public:
  explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// `cells`: one per column.
  void add(std::vector<std::string> cells);

  const std::vector<Column>& columns() const { return columns_; }
  const std::vector<std::vector<std::string>>& rows() const { return rows_; }

  /// Title line and rows, each line after `indent` blanks; the title line is left out when all titles are empty.
  std::string text(std::size_t indent = 2) const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// A number with six significant digits; "–" when it is not finite.
std::string number(double value);

/// With the digits that an error leaves, two of the error's own; with six at most, as without one.
std::string number(double value, const std::optional<double>& error);

/// With all its digits; empty when there is none, or it is not finite.
std::string csv_number(const std::optional<double>& value);

/// One CSV line: fields with commas, quotes or line ends are quoted (RFC 4180).
std::string csv_line(const std::vector<std::string>& fields);

}  // namespace jointid::report

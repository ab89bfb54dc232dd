#include "report/text/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace jointid::report {
namespace {

/// Characters of a UTF-8 text: bytes that do not continue another.
std::size_t display_width(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string padded(const std::string& text, std::size_t columns, Align align) {
  const std::string blanks(columns - display_width(text), ' ');
  return align == Align::left ? text + blanks : blanks + text;
}

std::string quoted(const std::string& field) {
  if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
  std::string text = "\"";
  for (const char c : field) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

}  // namespace

void Table::add(std::vector<std::string> cells) {
  assert(cells.size() == columns_.size());
  rows_.push_back(std::move(cells));
}

std::string Table::text(std::size_t indent) const {
  std::vector<std::string> titles;
  for (const Column& column : columns_) titles.push_back(column.title);
  std::vector<std::vector<std::string>> lines = rows_;
  if (std::ranges::any_of(titles, [](const std::string& title) { return !title.empty(); })) {
    lines.insert(lines.begin(), titles);
  }
  std::vector<std::size_t> widths(columns_.size(), 0);
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], display_width(line[i]));
  }
  std::string text;
  for (const auto& line : lines) {
    std::string row(indent, ' ');
    for (std::size_t i = 0; i < line.size(); ++i) {
      row += (i == 0 ? "" : "  ") + padded(line[i], widths[i], columns_[i].align);
    }
    text += row.substr(0, row.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string number(double value) { return std::isfinite(value) ? fmt::format("{:.6g}", value) : "–"; }

std::string number(double value, const std::optional<double>& error) {
  if (!error || !std::isfinite(*error) || *error <= 0.0 || !std::isfinite(value) || value == 0.0) return number(value);
  const double digits = std::floor(std::log10(std::abs(value))) - std::floor(std::log10(*error)) + 2.0;
  return fmt::format("{:.{}g}", value, static_cast<int>(std::clamp(digits, 1.0, 6.0)));
}

std::string csv_number(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? fmt::format("{}", *value) : std::string();
}

std::string csv_line(const std::vector<std::string>& fields) {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) line += (i == 0 ? "" : ",") + quoted(fields[i]);
  return line + "\n";
}

}  // namespace jointid::report

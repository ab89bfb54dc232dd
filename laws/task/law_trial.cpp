#include "laws/task/law_trial.hpp"

#include <fmt/format.h>

#include <charconv>
#include <sstream>

#include "base/statistics.hpp"

namespace jointid::laws {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

}  // namespace

std::string line_of(const LawTrial& trial, std::size_t values) {
  std::string text = fmt::format("{},{},{},{:d},{:d},{:d},{:d},{}", trial.trial, trial.status, trial.laws, trial.usable,
                                 trial.contradicts, trial.undecided, trial.missed, trial.chi_square);
  for (std::size_t i = 0; i < values; ++i) {
    const LawTrial::Value value = i < trial.values.size() ? trial.values[i] : LawTrial::Value{nan, nan, nan};
    text += fmt::format(",{},{},{}", value.value, value.low, value.high);
  }
  return text + "\n";
}

std::optional<LawTrial> trial_of(const std::string& line, std::size_t values) {
  constexpr std::size_t before = 8;
  const std::vector<std::string> cells = cells_of(line);
  if (cells.size() != before + 3 * values) return std::nullopt;
  const auto number = [](const std::string& cell) {
    double value = nan;
    if (cell != "nan" && cell != "-nan" && std::from_chars(cell.data(), cell.data() + cell.size(), value).ec != std::errc())
      value = nan;
    return value;
  };
  LawTrial out;
  if (std::from_chars(cells[0].data(), cells[0].data() + cells[0].size(), out.trial).ec != std::errc()) return std::nullopt;
  out.status = cells[1];
  out.laws = cells[2];
  out.usable = cells[3] == "1";
  out.contradicts = cells[4] == "1";
  out.undecided = cells[5] == "1";
  out.missed = cells[6] == "1";
  out.chi_square = number(cells[7]);
  for (std::size_t i = 0; i < values; ++i)
    out.values.push_back({number(cells[before + 3 * i]), number(cells[before + 3 * i + 1]), number(cells[before + 3 * i + 2])});
  return out;
}

}  // namespace jointid::laws

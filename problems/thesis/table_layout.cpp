#include "problems/thesis/table_layout.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <sstream>

namespace jointid::problems {
namespace {

using restrictions::Kind;

struct Row {
  std::string label;
  std::vector<Print> prints;
};

/// Decimals behind the point, less the exponent: "-2.3e-4" has five.
int decimals(const std::string& text) {
  const std::size_t exponent = text.find('e');
  const std::string mantissa = text.substr(0, exponent);
  const std::size_t point = mantissa.find('.');
  const int places = point == std::string::npos ? 0 : static_cast<int>(mantissa.size() - point - 1);
  return places - (exponent == std::string::npos ? 0 : std::stoi(text.substr(exponent + 1)));
}

Print read_print(std::string word) {
  const bool doubtful = word.back() == '?';
  if (doubtful) word.pop_back();
  return {word, std::stod(word), 0.5 * std::pow(10.0, -decimals(word)), doubtful};
}

std::vector<Row> read_rows(const char* text) {
  std::vector<Row> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    Row row;
    if (!(words >> row.label)) continue;
    for (std::string word; words >> word;) row.prints.push_back(read_print(word));
    rows.push_back(std::move(row));
  }
  return rows;
}

std::size_t run_of(ThesisTable& table, const std::string& problem) {
  const auto found = std::ranges::find(table.runs, problem, &TableRun::problem);
  if (found != table.runs.end()) return static_cast<std::size_t>(found - table.runs.begin());
  table.runs.push_back({problem, {}, {}, {}});
  return table.runs.size() - 1;
}

}  // namespace

std::vector<TablePlace> upper_triangle() {
  std::vector<TablePlace> places;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i; j < 4; ++j) {
      places.push_back({"(" + std::to_string(i + 1) + "," + std::to_string(j + 1) + ")", i, j});
    }
  }
  return places;
}

void add_cases(ThesisTable& table, Kind kind, const std::vector<TablePlace>& places, const char* rows) {
  for (const Row& row : read_rows(rows)) {
    assert(row.prints.size() <= places.size());
    const std::size_t run = run_of(table, row.label);
    for (std::size_t k = 0; k < row.prints.size(); ++k) {
      table.entries.push_back({row.label, restrictions::symbol(kind) + places[k].label, run, kind, TableFigure::element,
                               places[k].i, places[k].j, row.prints[k]});
    }
  }
}

void add_row(ThesisTable& table, const TableRun& run, Kind kind, const std::vector<TablePlace>& places, double unit, const char* row) {
  const Row read = read_rows(row).front();
  assert(read.prints.size() == places.size());
  // K and D of one case are of the same run.
  const bool known = !table.entries.empty() && table.entries.back().row == read.label;
  if (!known) table.runs.push_back(run);
  for (std::size_t k = 0; k < places.size(); ++k) {
    table.entries.push_back({read.label, restrictions::symbol(kind) + places[k].label, table.runs.size() - 1, kind, TableFigure::element,
                             places[k].i, places[k].j, read.prints[k], unit, {}});
  }
}

ThesisTable factor_pairs(std::string number, std::string title, Kind kind, const std::vector<ident::Equation>& equations,
                         const char* rows) {
  const std::array<std::pair<const char*, double>, 8> deltas = {
      {{"0", 0.0}, {"0.02", 0.02}, {"0.05", 0.05}, {"0.1", 0.1}, {"0.2", 0.2}, {"0.3", 0.3}, {"0.4", 0.4}, {"0.5", 0.5}}};
  ThesisTable table{std::move(number), std::move(title), {}, {}, {}};
  for (const Row& row : read_rows(rows)) {
    assert(row.prints.size() == 2 * deltas.size());
    const std::size_t first = table.runs.size();
    for (const auto& [label, delta] : deltas) {
      table.runs.push_back({"B", equations, weighting::parse_weighting(row.label), delta});
    }
    for (const TableFigure figure : {TableFigure::rjcf, TableFigure::arvf}) {
      const std::size_t offset = figure == TableFigure::rjcf ? 0 : 1;
      for (std::size_t d = 0; d < deltas.size(); ++d) {
        table.entries.push_back({row.label + (offset == 0 ? " RJCF" : " ARVF"), std::string("Δ ") + deltas[d].first,
                                 first + d, kind, figure, 0, 0, row.prints[2 * d + offset]});
      }
    }
  }
  return table;
}

ThesisTable elements_of_b(std::string number, std::string title, std::vector<TableRun> runs,
                          const std::vector<std::string>& columns, const char* rows) {
  constexpr std::array<std::array<std::size_t, 2>, 6> places = {{{0, 0}, {0, 1}, {0, 2}, {0, 3}, {1, 1}, {1, 3}}};
  constexpr std::array<Kind, 3> kinds = {Kind::stiffness, Kind::mass, Kind::hysteretic_damping};
  ThesisTable table{std::move(number), std::move(title), std::move(runs), {}, {}};
  const std::vector<Row> lines = read_rows(rows);
  assert(lines.size() == kinds.size() * places.size());
  for (std::size_t r = 0; r < lines.size(); ++r) {
    const auto [i, j] = places[r % places.size()];
    assert(lines[r].prints.size() == columns.size());
    for (std::size_t c = 0; c < columns.size(); ++c) {
      table.entries.push_back({lines[r].label, columns[c], c, kinds[r / places.size()], TableFigure::element, i, j,
                               lines[r].prints[c]});
    }
  }
  return table;
}

}  // namespace jointid::problems

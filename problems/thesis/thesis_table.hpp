#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ident/scene/scene.hpp"

namespace jointid::problems {

/// A number as the thesis prints it.
struct Print {
  std::string text;
  double value = 0.0;
  double half_unit = 0.0;  ///< half a unit of the last printed digit: what rounding may have taken
  bool doubtful = false;   ///< contradicts its neighbours or another table; see ThesisTable::notes
};

/// A built-in problem, with the choices of its scene or others.
struct TableRun {
  std::string problem;
  std::vector<ident::Equation> equations;  ///< empty: the problem's own
  std::optional<weighting::Weighting> weighting;
  std::optional<double> delta;
  bool noise_free = false;
  double median_floor = 0.0;  ///< beside the problem's errors a floor, as a share of the median modulus of each FRF
  std::optional<std::array<double, 2>> range_hz = {};  ///< empty: all lines of the problem
};

enum class TableFigure { element, rjcf, arvf };

/// A multiple of an element of a matrix, from 0.
struct TableTerm {
  double factor = 1.0;
  std::size_t i = 0, j = 0;
};

/// One number of a table and what it is: an element of an identified matrix divided by its true value or by the table's unit, a sum of
/// such elements, or a figure of merit.
struct TableEntry {
  std::string row, column;
  std::size_t run = 0;
  restrictions::Kind kind = restrictions::Kind::stiffness;
  TableFigure figure = TableFigure::element;
  std::size_t i = 0, j = 0;  ///< of an element, from 0
  Print print;
  double unit = 0.0;              ///< what elements are divided by; 0: their true values
  std::vector<TableTerm> sum{};  ///< instead of one element, over `unit`
};

/// A table of chapters 6 and 7 of Y. Ren's thesis (1992).
struct ThesisTable {
  std::string number;  ///< "6.3", "7.2"
  std::string title;
  std::vector<TableRun> runs;
  std::vector<TableEntry> entries;  ///< row by row
  std::vector<std::string> notes;   ///< where our problem is not that of the print, and what is doubtful in it
};

}  // namespace jointid::problems

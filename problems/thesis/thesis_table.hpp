#pragma once

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
};

enum class TableFigure { element, rjcf, arvf };

/// One number of a table and what it is: an element of an identified matrix divided by its true value, or a figure of merit.
struct TableEntry {
  std::string row, column;
  std::size_t run = 0;
  restrictions::Kind kind = restrictions::Kind::stiffness;
  TableFigure figure = TableFigure::element;
  std::size_t i = 0, j = 0;  ///< of an element, from 0
  Print print;
};

/// A table of chapter 6 of Y. Ren's thesis (1992).
struct ThesisTable {
  std::string number;  ///< "6.3"
  std::string title;
  std::vector<TableRun> runs;
  std::vector<TableEntry> entries;  ///< row by row
  std::vector<std::string> notes;   ///< where our problem is not that of the print, and what is doubtful in it
};

}  // namespace jointid::problems

#pragma once

#include <string>
#include <vector>

#include "problems/thesis/thesis_table.hpp"

/// Tables from the text of their rows: a label and the numbers, with "?" after a doubtful one.
namespace jointid::problems {

struct TablePlace {
  std::string label;  ///< "(1,2)"
  std::size_t i = 0, j = 0;
};

/// (1,1), (1,2), … (4,4): the upper triangle row by row.
std::vector<TablePlace> upper_triangle();

/// Adds one row and one run per built-in problem, which is the row's label; rows may end early. Runs that the table has already are
/// used again.
void add_cases(ThesisTable& table, restrictions::Kind kind, const std::vector<TablePlace>& places, const char* rows);

/// A problem's matrix in numbers of `unit`: one row of the table, one run. `row` is a label and the numbers, with the run's choices.
void add_row(ThesisTable& table, const TableRun& run, restrictions::Kind kind, const std::vector<TablePlace>& places, double unit,
             const char* row);

/// The ways of Tables 6.6 to 6.11 on problem B: rows are weightings, with (RJCF, ARVF) per Δ.
ThesisTable factor_pairs(std::string number, std::string title, restrictions::Kind kind,
                         const std::vector<ident::Equation>& equations, const char* rows);

/// Problem B with equation nn: one column per run, rows the six elements of K, then of M, then of D.
ThesisTable elements_of_b(std::string number, std::string title, std::vector<TableRun> runs,
                          const std::vector<std::string>& columns, const char* rows);

}  // namespace jointid::problems

#pragma once

#include <string>
#include <vector>

#include "report/text/table.hpp"
#include "study/comparison.hpp"

/// What a comparison found, for text and page.
namespace jointid::report {

/// Tables 6.6 to 6.11 of the thesis: rows weighting, columns Δ, cells the medians of RJCF and ARVF.
struct PairTable {
  std::string title;  ///< method, equations and solver, which it holds constant
  Table table;
};

/// Method, equations, weighting, Δ and solver.
std::vector<std::string> way_cells(const study::Way& way);

/// Of the judged matrix number `matrix`; one per method, equations and solver with several Δ.
std::vector<PairTable> pair_tables(const std::vector<study::Combination>& all, std::size_t matrix);

/// One row per combination: figures of merit of the matrix, bias, time, and whether it is on the Pareto front.
Table figures_table(const std::vector<study::Combination>& all, std::size_t matrix);

/// One row per combination: rms error of its worst matrix (median), time, memory and how the trials ended.
Table cost_table(const std::vector<study::Combination>& all);

/// "two nn, 30 combinations: reason": one line for those that follow each other with the same method, equations and reason.
std::vector<std::string> left_out_lines(const std::vector<study::LeftOut>& left_out);

}  // namespace jointid::report

#pragma once

#include <string>
#include <vector>

#include "report/text/table.hpp"

namespace jointid::report {

/// What a way of solving gave and what it took; the one form in which `compare` and `stability` show it.
struct CostRow {
  std::vector<std::string> way;  ///< cells that say which way, and how large a problem
  std::string accuracy;          ///< error, or digits
  double seconds = 0.0;
  std::size_t bytes = 0;
  std::string outcome;           ///< how it ended
};

/// Columns of the way, then accuracy, ms, kB and outcome.
Table cost_table(std::vector<Column> way, const std::string& accuracy, const std::string& outcome, const std::vector<CostRow>& rows);

}  // namespace jointid::report

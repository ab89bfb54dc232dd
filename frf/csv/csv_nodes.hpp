#pragma once

#include <string>
#include <vector>

#include "frf/csv/csv_table.hpp"
#include "frf/set/frf_set.hpp"

namespace jointid::frf {

/// Nodes by the lines `# node ID = X Y Z` of a table, m; numbers separated by blanks, commas or semicolons. Ascending numbers.
/// Throws InputError (data) naming the line of one that does not fit.
std::vector<Node> read_csv_nodes(const CsvTable& table);

/// The same lines.
std::string csv_nodes_text(const std::vector<Node>& nodes);

}  // namespace jointid::frf

#pragma once

#include <filesystem>
#include <vector>

#include "frf/set/frf_set.hpp"
#include "frf/uff/uff_lines.hpp"

namespace jointid::frf {

/// Positions of nodes, m: datasets 15 and 2411 of a universal file; else a table of frf::read_columns() with the columns node (or id,
/// point, nr), x, y and z, whose titles or rows of units state a length, without one m. Throws InputError (data) for columns that are
/// missing, a unit that is no length, numbers of nodes that are not whole or come twice, positions that are not finite, and numbers
/// without a unit that would be further than 100 m apart.
std::vector<Node> read_node_table(const std::filesystem::path& path);

/// Lines to draw between the nodes of such a table: each row is joined to the nodes in its columns to, to2, to3, …, none where
/// these are blank or 0; of a universal file read_uff_lines(). None without these columns. Throws InputError (data) as above.
std::vector<NodeLine> read_node_lines(const std::filesystem::path& path);

}  // namespace jointid::frf

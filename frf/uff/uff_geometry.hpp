#pragma once

#include <vector>

#include "frf/set/frf_set.hpp"
#include "frf/uff/uff_scan.hpp"
#include "frf/uff/uff_unit_table.hpp"

namespace jointid::frf::uff {

/// Nodes of datasets 15 and 2411, positions in m; the first position given for a node counts. Those that are defined in a
/// coordinate system which no dataset 2420 or 18 of the file describes are left out; axes of DOFs are those of the displacement
/// system (CoordinateSystems).
std::vector<Node> read_nodes(ByteFile& file, const std::vector<Dataset>& datasets, const UnitTable& units);

}  // namespace jointid::frf::uff

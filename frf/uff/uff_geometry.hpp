#pragma once

#include <vector>

#include "frf/set/frf_set.hpp"
#include "frf/uff/uff_scan.hpp"
#include "frf/uff/uff_units.hpp"

namespace jointid::frf::uff {

/// The datasets 164 of a file. Throws InputError when a factor is not a positive number.
class UnitTable {
 public:
  UnitTable(ByteFile& file, const std::vector<Dataset>& datasets);

  /// The factors that hold for `dataset`: those of the last 164 before it, else of the first in the file,
  /// else 1.
  UnitFactors at(const Dataset& dataset) const;

 private:
  struct Entry {
    std::uint64_t byte;
    UnitFactors factors;
  };
  std::vector<Entry> entries_;  ///< in the order of the file
};

/// Nodes of datasets 15 and 2411, positions in m; the first position given for a node counts. Those that are defined in a
/// coordinate system which no dataset 2420 of the file describes are left out; axes of DOFs are those of the displacement system
/// (CoordinateSystems).
std::vector<Node> read_nodes(ByteFile& file, const std::vector<Dataset>& datasets, const UnitTable& units);

}  // namespace jointid::frf::uff

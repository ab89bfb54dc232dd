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

/// Node positions in m of datasets 15 and 2411; the first position given for a node counts. Nodes defined in
/// a coordinate system other than 0 and 1, which are global Cartesian, are left out.
std::vector<Node> read_nodes(ByteFile& file, const std::vector<Dataset>& datasets, const UnitTable& units);

}  // namespace jointid::frf::uff

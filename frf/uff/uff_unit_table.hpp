#pragma once

#include <cstdint>
#include <vector>

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

}  // namespace jointid::frf::uff

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "frf/hdf5_module/hdf5_object.hpp"

namespace jointid::frf::hdf5 {

/// Where the lines of a dataset [F,R,C] lie in its file, so that parts of them can be read past HDF5: one
/// system call into the caller's memory, no chunk cache, no library-wide lock. Addresses are looked up when
/// first needed.
class LineMap {
 public:
  /// Nothing unless the dataset is contiguous or chunked by whole lines, unfiltered, of elements stored just
  /// as `memory_type` lays them out in memory, in a file without user block.
  static std::optional<LineMap> of(const Object& file, const Dataset& dataset, const Handle& memory_type);

  /// Reads bytes `from` … `from + out.size()` of a line. Throws InputError when the file ends before.
  void read(const Dataset& dataset, std::size_t line, std::size_t from, std::span<std::byte> out);

 private:
  std::uint64_t chunk_address(const Dataset& dataset, std::size_t chunk);

  int descriptor_ = -1;  ///< owned by the open HDF5 file
  std::size_t lines_per_chunk_ = 1;
  std::size_t line_bytes_ = 0;
  std::vector<std::uint64_t> addresses_;  ///< per chunk; 0 (no data can lie there) until looked up
};

}  // namespace jointid::frf::hdf5

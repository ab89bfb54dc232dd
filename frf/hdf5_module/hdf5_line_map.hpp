#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
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

  /// Looks up what reads will need and keeps the file's data open by itself, so that HDF5 may close it: an open file costs it half a
  /// megabyte. False, and nothing is changed, where there is too much to look up.
  bool stand_alone(const Dataset& dataset);

  /// Reads bytes `from` … `from + out.size()` of a line. Throws InputError when the file ends before.
  void read(const Dataset& dataset, std::size_t line, std::size_t from, std::span<std::byte> out);

 private:
  std::uint64_t chunk_address(const Dataset& dataset, std::size_t chunk);

  /// An open file of its own.
  class Descriptor {
   public:
    Descriptor() = default;
    explicit Descriptor(int of) : number_(of) {}
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
      std::swap(number_, other.number_);
      return *this;
    }
    ~Descriptor();

    int number() const { return number_; }

   private:
    int number_ = -1;
  };

  int descriptor_ = -1;  ///< owned by the open HDF5 file, or by `own_`
  Descriptor own_;
  std::size_t lines_per_chunk_ = 1;
  std::size_t line_bytes_ = 0;
  std::vector<std::uint64_t> addresses_;  ///< per chunk; 0 (no data can lie there) until looked up
};

}  // namespace jointid::frf::hdf5

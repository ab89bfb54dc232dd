#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "frf/uff/uff58_header.hpp"
#include "frf/uff/uff_bytes.hpp"

namespace jointid::frf::uff {

/// One dataset of a file: what it is and where its data stand. Nothing of the data is held.
struct Dataset {
  int number = 0;
  bool binary = false;  ///< a "b" stands after the number
  Place place;
  std::uint64_t payload_begin = 0;   ///< first byte after the number line; for 58 after its header
  std::uint64_t payload_end = 0;     ///< one past the last byte before the closing -1
  std::uint64_t payload_lines = 0;   ///< text only: lines that are not blank
  bool cut_off = false;              ///< text only: the file ends inside a line of this dataset
  int byte_order = 0;                ///< binary only: 1 little endian, 2 big endian
  int float_format = 0;              ///< binary only: 1 DEC VMS, 2 IEEE 754, 3 IBM 5/370
  std::uint64_t abscissa_bytes = 0;  ///< binary uneven 58 only: 4 or 8
  std::optional<Header58> function;  ///< 58 only

  std::string name() const { return std::to_string(number) + (binary ? "b" : ""); }
};

/// Goes through the file once and lists its datasets. Text is passed line by line; a binary payload is
/// skipped by its size, never searched. The size of a 58b comes from record 7 and not from the byte count of
/// its number line. The abscissas of uneven double precision are singles by the standard's Addendum B and
/// doubles in many programs: the size behind which a closing -1 stands is taken. A closing -1 may be missing
/// at the end of the file only.
std::vector<Dataset> scan(ByteFile& file);

}  // namespace jointid::frf::uff

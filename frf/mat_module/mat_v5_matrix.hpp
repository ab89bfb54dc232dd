#pragma once

#include <cstdint>
#include <string>

#include "frf/mat_module/mat_v5_bytes.hpp"

namespace jointid::frf::mat {

/// Types of data elements of the MAT-file format, level 5.
enum DataType : std::uint32_t { mi_int8 = 1, mi_int32 = 5, mi_uint32 = 6, mi_matrix = 14, mi_compressed = 15 };

/// The first eight bytes of a data element: its type and how many bytes follow; small elements hold up to four in the tag itself.
struct Tag {
  std::uint32_t type = 0;
  std::uint32_t bytes = 0;
  bool small = false;

  static Tag parse(std::span<const unsigned char, 8> bytes, bool big_endian);
};

/// How many arrays inside of others a file may have.
using Nested = std::uint64_t;

enum class Extent : std::uint8_t {
  header,  ///< stops before the numbers or characters of the array itself; what is inside of cells and structures is walked
  whole
};

/// Walks an array of `size` bytes after its tag and returns its name. Throws Damaged when a declared size does not fit what holds
/// it, when dimensions and number of elements disagree, for types and classes that the format does not have, for arrays nested
/// more than 64 deep, and for more of them than are left in `nested`, from which they are taken.
std::string walk_matrix(Bytes& bytes, bool big_endian, std::uint64_t size, Extent extent, Nested& nested);

}  // namespace jointid::frf::mat

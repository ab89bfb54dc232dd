#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "frf/hdf5_module/hdf5_line_map.hpp"
#include "frf/hdf5_module/hdf5_object.hpp"
#include "frf/set/frf_source.hpp"

namespace jointid::frf::hdf5 {

/// Reads blocks of a dataset [F,R,C] of T (Complex or double), touching only the lines and rows that a block
/// names. Plain datasets are read past HDF5 (LineMap); all others (compressed, other chunks, other number
/// formats) by hyperslabs that bound the block's rows and columns.
template <class T>
class LineReader {
 public:
  /// Opens `name` of `file`. Throws InputError unless it is [F,R,C] as in `header` and holds complex {r,i}
  /// (Complex) or real numbers (double).
  LineReader(const Object& file, const std::string& name, const FrfHeader& header);

  /// The same of [F,rows,columns].
  LineReader(const Object& file, const std::string& name, const std::array<std::size_t, 3>& dims);

  /// Whether reads need no HDF5 from now on; then the dataset is closed.
  bool stand_alone();

  /// Values as stored, in the order [line, response, reference] of the block.
  void read(const Block& block, std::span<T> out);

 private:
  struct Window;

  void read_mapped(const Block& block, std::span<T> out);
  void read_slabs(const Block& block, std::span<T> out);
  void read_slab(const Window& window, std::size_t first_line, std::size_t lines, T* to);

  Dataset dataset_;
  Handle memory_type_;
  std::optional<LineMap> map_;
  std::vector<T> scratch_;
};

}  // namespace jointid::frf::hdf5

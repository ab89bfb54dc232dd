#pragma once

#include <complex>
#include <cstdint>
#include <vector>

#include "frf/uff/uff_scan.hpp"

namespace jointid::frf::uff {

/// Points of a dataset 58 in the file's own units. `abscissa` is empty for even spacing.
struct Points {
  std::vector<double> abscissa;
  std::vector<std::complex<double>> values;  ///< imaginary part 0 for real data
};

/// Throws InputError unless the floating-point format and byte order are ones that can be read.
void require_readable(const Dataset& dataset);

/// Reads points [first, first + count). Binary data are read from there; text is read from its beginning.
/// Throws InputError naming how many of how many values were found when the data end early.
Points read_points(ByteFile& file, const Dataset& dataset, std::uint64_t first, std::uint64_t count);

/// All points; nothing is allocated for points that the file does not hold.
Points read_points(ByteFile& file, const Dataset& dataset);

/// Throws what read_points would throw if the text is so short that it cannot hold the declared points, and where the numbers of
/// binary data make sense in the other byte order alone.
void require_plausible_size(ByteFile& file, const Dataset& dataset);

}  // namespace jointid::frf::uff

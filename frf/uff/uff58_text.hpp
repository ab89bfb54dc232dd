#pragma once

#include <vector>

#include "frf/uff/uff_scan.hpp"

namespace jointid::frf::uff {

/// All numbers of a text record in file order. A line is cut at its columns when its fields touch;
/// blank-separated numbers of other widths are accepted; a blank field inside a line is an error, at the end
/// of the last line it is not.
std::vector<double> read_text_numbers(ByteFile& file, const Dataset& dataset);

}  // namespace jointid::frf::uff

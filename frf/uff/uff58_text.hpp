#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "frf/uff/uff_scan.hpp"

namespace jointid::frf::uff {

/// Widths of the columns of a data line (record 12): 6E13.5, 4E20.12, 2(E13.5,E20.12) or E13.5,2E20.12.
std::span<const std::size_t> text_columns(const Header58& header);

/// All numbers of a text record in file order. A line is cut at its columns when its fields touch;
/// blank-separated numbers of other widths are accepted; a blank field inside a line is an error, at the end
/// of the last line it is not.
std::vector<double> read_text_numbers(ByteFile& file, const Dataset& dataset);

}  // namespace jointid::frf::uff

#pragma once

#include <string>
#include <string_view>

#include "frf/npy/npy_header.hpp"
#include "frf/set/frf_source.hpp"

namespace jointid::frf {

/// Whether records are functions at DOFs, as SDynPy stores them: fields abscissa, ordinate and coordinate.
bool are_functions(const NpyHeader& header);

/// The FRFs of such records: abscissa (Hz) and complex ordinate, one after another, coordinate.node and coordinate.direction (codes of
/// UFF 58, 3 is +Z) of response and reference. All are on the lines of the first. They have no unit: SI is taken, the quantity is
/// OpenOptions::quantity. Throws InputError naming the record whose DOFs, lines or numbers are none of an FRF.
FrfSet read_functions(const NpyHeader& header, std::string_view elements, const std::string& file, const OpenOptions& options);

/// Throws InputError: records of other fields.
[[noreturn]] void fail_records(const std::string& file);

}  // namespace jointid::frf

#pragma once

#include <filesystem>
#include <string>

#include "frf/set/frf_set.hpp"

namespace jointid::frf {

/// Writes a set in the format of the file's extension, or of `format` when given: h5 or hdf5 (jointid-frf),
/// uff or unv (UFF 58b), mat (MATLAB v5), csv. Throws InputError (usage) for any other.
void write(const FrfSet& set, const std::filesystem::path& path, std::string format = "");

}  // namespace jointid::frf

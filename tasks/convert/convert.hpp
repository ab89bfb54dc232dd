#pragma once

#include <filesystem>

#include "frf/noise/turned_points.hpp"
#include "frf/set/frf_source.hpp"
#include "ident/result/control.hpp"

namespace jointid::tasks {

/// Whether a file of that name is written as HDF5: .h5 or .hdf5.
bool is_hdf5(const std::filesystem::path& path);

/// Writes the FRFs of a source in the format of the file's ending. HDF5 is written line by line, with covariances; the file can
/// be larger than the memory. Other formats are written at once, without. Returns false, without a file, if interrupted. Several
/// files of one structure: frf::open_as_one(). `turned`, if given, sees all values. Throws InputError for unknown endings, and as
/// frf::write().
bool convert(frf::FrfSource& source, const std::filesystem::path& path, const ident::Control& control = {},
             frf::TurnedPoints* turned = nullptr);

}  // namespace jointid::tasks

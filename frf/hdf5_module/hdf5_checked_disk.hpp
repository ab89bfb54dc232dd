#pragma once

#include <filesystem>

#include "frf/hdf5_module/hdf5_first_look.hpp"
#include "frf/hdf5_module/hdf5_handle.hpp"

namespace jointid::frf::hdf5 {

/// Opens a file for reading through a driver that looks at what HDF5 takes on trust: at the whole file first, in a process of its own
/// (first_look(), whose answer goes to `finding`), and at global heaps as they are read. The handle is not open where HDF5 or the
/// first look refuses the file.
Handle open_checked(const std::filesystem::path& path, Finding& finding);

/// The same without the first look.
Handle open_without_look(const std::filesystem::path& path);

}  // namespace jointid::frf::hdf5

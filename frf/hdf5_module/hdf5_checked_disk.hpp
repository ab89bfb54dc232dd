#pragma once

#include <filesystem>
#include <functional>

#include "frf/hdf5_module/hdf5_handle.hpp"

namespace jointid::frf::hdf5 {

/// Whether HDF5 may see a file; asked with its lock held, so that no other thread is inside of it.
using MayOpen = std::function<bool(const std::filesystem::path&)>;

/// Opens a file for reading through a driver that looks at what HDF5 takes on trust: global heaps as they are read, and
/// addresses beyond the end of the file. The handle is not open where HDF5 or `may_open`, if there is such, refuses the file.
Handle open_checked(const std::filesystem::path& path, const MayOpen& may_open = {});

}  // namespace jointid::frf::hdf5

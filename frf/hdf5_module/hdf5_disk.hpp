#pragma once

#include <filesystem>

#include "frf/hdf5_module/hdf5_handle.hpp"

namespace jointid::frf::hdf5 {

/// Creates (truncates) a file through a driver that keeps disk failures from HDF5. HDF5 1.10 cannot close a
/// file whose last blocks the disk refuses: it stays half open and crashes the process at its end. Here the
/// first failure goes to `error` (an errno, 0 before; it must outlive the file), later writes go nowhere, and
/// closing succeeds: whoever writes looks at `error` after every call and throws the file away when it is not
/// 0. The handle is not open when the file cannot be created.
Handle create_file(const std::filesystem::path& path, int& error);

}  // namespace jointid::frf::hdf5

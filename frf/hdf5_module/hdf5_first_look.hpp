#pragma once

#include <filesystem>

namespace jointid::frf::hdf5 {

/// What a first look at a file found.
enum class Finding {
  nothing,   ///< HDF5 went through it, or said itself what is wrong
  crash,     ///< HDF5 crashed
  no_end,    ///< it took more processor time than a file of this size explains
  no_memory  ///< it asked for more memory
};

/// HDF5 1.10 believes what a file says of itself: damaged bytes can crash it, or keep it busy for ever. So all objects of a file are read
/// once in a process of its own, with limits that grow with the file's size: 1 s + 1 s per 20 MB of processor time, 64 MB + 2,200 times
/// its size of memory (deflate packs up to 1,032 bytes into one). Of data beyond 4 MB the first and the last element. Files that were
/// found good are remembered until they change. Where no process can be made, nothing is found. To be called with HDF5's lock held.
Finding first_look(const std::filesystem::path& path);

}  // namespace jointid::frf::hdf5

#pragma once

#include <cstdint>

namespace jointid::frf::hdf5 {

/// Whether bytes read at `address` begin a global heap collection, in which HDF5 keeps texts of variable length.
bool begins_global_heap(const void* bytes, std::size_t count);

/// Whether the objects of the collection at `address` of the open file lie inside of it, and it inside of the file. HDF5 1.10 goes through
/// them by the sizes that they state themselves: beyond the end, or round and round.
bool is_sound_global_heap(int descriptor, std::uint64_t address);

}  // namespace jointid::frf::hdf5

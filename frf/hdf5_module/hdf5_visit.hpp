#pragma once

#include "frf/hdf5_module/hdf5_handle.hpp"

namespace jointid::frf::hdf5 {

/// From now on memory that HDF5 did not set, or gave back, leads nowhere: what it does with such is seen at once. For the rest of the
/// process.
void poison_memory();

/// Reads all objects of an open file (or of one that could not be opened), as far as 4 MB of data go, and of the rest the first and the
/// last element; what HDF5 refuses is passed over. False where it wanted more memory than there is.
bool visit_all(const Handle& file);

}  // namespace jointid::frf::hdf5

#include "frf/hdf5/hdf5_module.hpp"

#include "base/module.hpp"

namespace jointid::frf {
namespace {

constexpr Module hdf5_library{"hdf5", "an HDF5 or MATLAB v7.3 file", "libhdf5-dev"};

}  // namespace

Hdf5Module& hdf5_module() { return interface_of<Hdf5Module>(hdf5_library); }

bool has_hdf5() { return is_there(hdf5_library); }

}  // namespace jointid::frf

#include "frf/hdf5/hdf5_file.hpp"

#include "frf/hdf5/hdf5_module.hpp"

namespace jointid::frf {

bool has_format_attribute(const std::filesystem::path& path) { return hdf5_module().has_format_attribute(path); }

std::unique_ptr<FrfSource> open_hdf5(const std::filesystem::path& path) { return hdf5_module().open(path); }

}  // namespace jointid::frf

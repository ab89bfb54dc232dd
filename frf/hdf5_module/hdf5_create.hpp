#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "frf/hdf5_module/hdf5_handle.hpp"
#include "frf/set/frf_set.hpp"

namespace jointid::frf::hdf5 {

/// Each writes something small and whole; false when HDF5 refuses.
bool write_text_attribute(const Handle& object, const char* name, const std::string& text);
bool write_number_attribute(const Handle& object, const char* name, double value);
bool write_integer_attribute(const Handle& object, const char* name, std::int64_t value);
bool write_axis(const Handle& file, const std::vector<double>& frequency_hz);
bool write_dofs(const Handle& file, const char* name, const std::vector<Dof>& dofs);
bool write_nodes(const Handle& file, const std::vector<Node>& nodes);

/// Creates an empty dataset [F,R,C] of `type`, chunked by whole lines; the handle is not open when HDF5
/// refuses.
Handle create_lines(const Handle& file, const char* name, const Handle& type,
                    const std::array<std::size_t, 3>& dims, std::size_t lines_per_chunk, int compression);

}  // namespace jointid::frf::hdf5

#pragma once

#include <pybind11/pybind11.h>

#include "frf/set/frf_set.hpp"

namespace jointid::python {

/// FRFs across the border: arrays that Python keeps as a file in memory, sets that are read as buffers, sets that are written.
void bind_sets(pybind11::module_& module);

/// A set as a dict: "name", "frequency", "responses", "references", "quantity", "frfs" … in the quantity of its header; numbers
/// are buffers that own them.
pybind11::dict dict_of(frf::FrfSet set);

}  // namespace jointid::python

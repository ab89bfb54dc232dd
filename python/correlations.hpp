#pragma once

#include <pybind11/pybind11.h>

namespace jointid::python {

/// correlate of two files or sets in memory, expand.
void bind_correlations(pybind11::module_& module);

}  // namespace jointid::python

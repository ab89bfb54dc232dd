#pragma once

#include <pybind11/pybind11.h>

namespace jointid::python {

/// Built-in problems with known answers: those that identify a joint of FRFs.
void bind_problems(pybind11::module_& module);

}  // namespace jointid::python

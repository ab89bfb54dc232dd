#pragma once

#include <pybind11/pybind11.h>

namespace jointid::python {

/// export_joint(): a joint as cards of other programs.
void bind_exports(pybind11::module_& module);

}  // namespace jointid::python

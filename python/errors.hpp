#pragma once

#include <pybind11/pybind11.h>

namespace jointid::python {

/// InputError becomes jointid.InputError with its parts, Interrupted KeyboardInterrupt, lack of memory MemoryError.
void bind_errors(pybind11::module_& module);

}  // namespace jointid::python

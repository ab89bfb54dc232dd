#pragma once

#include <pybind11/pybind11.h>

namespace jointid::python {

/// Commands of FRFs and curves without a scene, of files or of arrays: modalfit, loading-curve; each with a class of its options.
void bind_file_tasks(pybind11::module_& module);

}  // namespace jointid::python

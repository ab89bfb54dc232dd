#pragma once

#include <pybind11/pybind11.h>

namespace jointid::python {

/// Commands of time records, of files or of arrays: frf, pod; each with a class of its options.
void bind_record_tasks(pybind11::module_& module);

}  // namespace jointid::python

#pragma once

#include <pybind11/pybind11.h>

namespace jointid::python {

/// Commands of scenes, their outcomes and virtual points.
void bind_scene_tasks(pybind11::module_& module);

}  // namespace jointid::python

#include <pybind11/pybind11.h>

#include "python/commit.hpp"
#include "python/correlations.hpp"
#include "python/errors.hpp"
#include "python/exports.hpp"
#include "python/file_tasks.hpp"
#include "python/problems.hpp"
#include "python/record_tasks.hpp"
#include "python/scene_tasks.hpp"
#include "python/sets.hpp"
#include "python/watch.hpp"

/// What the Python package `jointid` calls. NumPy is of the package alone: buffers are all that comes here.
PYBIND11_MODULE(_jointid, module) {
  namespace python = jointid::python;
  module.attr("__version__") = JOINTID_VERSION;
  module.attr("__commit__") = python::built_from();
  module.def("runs_left", python::runs_left);
  python::bind_errors(module);
  python::bind_sets(module);
  python::bind_scene_tasks(module);
  python::bind_file_tasks(module);
  python::bind_record_tasks(module);
  python::bind_problems(module);
  python::bind_correlations(module);
  python::bind_exports(module);
}

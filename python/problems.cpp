#include "python/problems.hpp"

#include <pybind11/stl.h>

#include <filesystem>
#include <string>

#include "problems/problem.hpp"

namespace jointid::python {
namespace {

namespace py = pybind11;

py::dict names_and_descriptions() {
  py::dict out;
  for (const problems::ProblemInfo& each : problems::list()) out[py::str(each.name)] = each.description;
  return out;
}

std::string write(const std::string& name, const std::string& directory, const std::string& format, std::uint64_t seed,
                  bool clean) {
  const py::gil_scoped_release release;
  return problems::write(problems::make(name), directory, {.format = format, .seed = seed, .method = {}, .clean = clean})
      .string();
}

}  // namespace

void bind_problems(py::module_& module) {
  module.def("problems", names_and_descriptions);
  module.def("write_problem", write);
}

}  // namespace jointid::python

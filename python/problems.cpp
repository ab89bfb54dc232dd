#include "python/problems.hpp"

#include <pybind11/stl.h>

#include <filesystem>
#include <string>

#include "problems/kinds/problem_kind.hpp"

namespace jointid::python {
namespace {

namespace py = pybind11;

py::dict names_and_descriptions() {
  py::dict out;
  for (const problems::ProblemKind& kind : problems::all_kinds()) {
    for (const problems::ProblemInfo& each : kind.list()) out[py::str(each.name)] = each.description;
  }
  return out;
}

std::string write_problem(const std::string& name, const std::string& directory, const std::string& format, std::uint64_t seed,
                  bool clean) {
  const py::gil_scoped_release release;
  const auto kinds = problems::all_kinds();
  const problems::ProblemKind* kind = problems::kind_of(kinds, name);
  if (kind == nullptr) problems::refuse_problem("there is no problem '" + name + "'", name, problems::names_of(kinds), "");
  return kind->write(name, directory, {.format = format, .seed = seed, .method = {}, .clean = clean}).file.string();
}

}  // namespace

void bind_problems(py::module_& module) {
  module.def("problems", names_and_descriptions);
  module.def("write_problem", write_problem);
}

}  // namespace jointid::python

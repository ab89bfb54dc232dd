#include "python/conversions.hpp"

#include "base/error.hpp"

namespace jointid::python {

namespace py = pybind11;

Paths paths_of(const std::vector<std::string>& names) { return {names.begin(), names.end()}; }

std::vector<std::string> names_of(const Paths& paths) {
  std::vector<std::string> names;
  for (const auto& path : paths) names.push_back(path.string());
  return names;
}

std::vector<double> doubles_of(const py::buffer& buffer) {
  const py::buffer_info info = buffer.request();
  if (info.format != "d") refuse("an array is not of float64", "numpy.ascontiguousarray(array, float) makes one");
  const auto* const begin = static_cast<const double*>(info.ptr);
  return {begin, begin + info.size};
}

}  // namespace jointid::python

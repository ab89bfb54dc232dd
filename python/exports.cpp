#include "python/exports.hpp"

#include <pybind11/stl.h>

#include <string>
#include <utility>
#include <vector>

#include "python/watch.hpp"
#include "report/export/export_files.hpp"
#include "tasks/export/exported_joint.hpp"

namespace jointid::python {
namespace {

namespace py = pybind11;

/// Endings and texts of the files.
std::vector<std::pair<std::string, std::string>> export_joint(const std::string& from, const std::string& to, const std::string& way,
                                                              bool millimetres, std::size_t band, std::size_t first_id,
                                                              std::size_t threads, const py::object& progress) {
  const report::ExportOptions options{.target = report::parse_export_target(to),
                                      .way = report::parse_export_way(way),
                                      .millimetres = millimetres,
                                      .first_id = first_id};
  return watched(progress, threads, [=](const ident::Control& control) {
    std::vector<std::pair<std::string, std::string>> out;
    for (report::ExportFile& file : report::export_files(tasks::exported_joint(from, band, control), options))
      out.emplace_back(std::move(file.suffix), std::move(file.text));
    return out;
  });
}

}  // namespace

void bind_exports(py::module_& module) { module.def("export_joint", export_joint); }

}  // namespace jointid::python

#include "python/correlations.hpp"

#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "python/outcome.hpp"
#include "python/watch.hpp"
#include "report/correlation/correlation_report.hpp"
#include "tasks/correlate/compared_files.hpp"

namespace jointid::python {
namespace {

namespace py = pybind11;

Outcome of_frfs(report::ComparedFiles files, const std::string& fdac) {
  const auto [one, other, notes] = tasks::read_compared(files.one, files.other);
  files.notes = notes;
  const auto found = std::make_shared<const correlation::CorrelatedFrfs>(correlation::correlate(one, other));
  std::shared_ptr<const correlation::ShapesOverLines> shapes;
  if (!fdac.empty())
    shapes =
        std::make_shared<const correlation::ShapesOverLines>(correlation::shapes_over_lines(one, other, frf::Dof::parse(fdac)));
  return {.status = "",
          .message = "",
          .json = [=] { return report::correlation_json(files, *found, shapes.get()); },
          .text = [=] { return report::correlation_text(files, *found); },
          .csv = [=] { return report::correlation_csv(*found); }};
}

Outcome of_modes(const report::ComparedFiles& files) {
  const auto found = std::make_shared<const correlation::CorrelatedModes>(
      correlation::correlate(tasks::read_modes(files.one), tasks::read_modes(files.other)));
  return {.status = "",
          .message = "",
          .json = [=] { return report::correlation_json(files, *found); },
          .text = [=] { return report::correlation_text(files, *found); },
          .csv = [=] { return report::correlation_csv(*found); }};
}

Outcome correlate(const std::string& one, const std::string& other, bool modes, const std::string& fdac,
                  const py::object& progress) {
  return watched(progress, 0, [=, files = report::ComparedFiles{one, other}](const ident::Control&) {
    return modes ? of_modes(files) : of_frfs(files, fdac);
  });
}

Outcome expand(const std::string& parent, const std::string& measured, const std::string& way, std::size_t modes,
               const py::object& progress) {
  return watched(progress, 0, [=](const ident::Control&) -> Outcome {
    const auto found = std::make_shared<const tasks::ExpandedFiles>(tasks::expanded_files(parent, measured, way, modes));
    const report::ExpansionNames names{parent, measured, way, "in memory", found->notes};
    return {.status = "",
            .message = "",
            .json = [=] { return report::expansion_json(names, found->expanded); },
            .text = [=] { return report::expansion_text(names, found->expanded); },
            .frfs = [=](const ident::Control&) { return found->expanded.set; }};
  });
}

}  // namespace

void bind_correlations(py::module_& module) {
  module.def("correlate", correlate);
  module.def("expand", expand);
}

}  // namespace jointid::python

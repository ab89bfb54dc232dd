#include "python/file_tasks.hpp"

#include <pybind11/stl.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "friction/curve/curve.hpp"
#include "python/conversions.hpp"
#include "python/outcome.hpp"
#include "python/watch.hpp"
#include "report/loading_curve/loading_curve_page.hpp"
#include "report/loading_curve/loading_curve_text.hpp"
#include "report/modalfit/modal_page.hpp"
#include "report/modalfit/modal_text.hpp"
#include "tasks/loading_curve/loading_curve_fit.hpp"
#include "tasks/modalfit/modal_run.hpp"

namespace jointid::python {
namespace {

namespace py = pybind11;
using std::chrono_literals::operator""ms;

/// For residues and synthesis of the modes that there are when Ctrl-C comes.
constexpr std::chrono::milliseconds patience = 700ms;

struct ModalTask {
  std::optional<std::array<double, 2>> range;
  std::optional<std::size_t> modes;
  std::optional<std::vector<std::array<double, 2>>> poles;  ///< Hz, damping
  bool real = false;
  std::string damping = "viscous";
};

modalfit::FitOptions options_of(const ModalTask& task) {
  modalfit::FitOptions options;
  options.kind = {modalfit::parse_damping(task.damping), task.real};
  options.range_hz = task.range;
  options.modes = task.modes;
  if (!task.poles) return options;
  options.poles.emplace();
  for (const auto& [frequency_hz, damping] : *task.poles) options.poles->push_back({frequency_hz, damping});
  return options;
}

Outcome outcome_of(tasks::ModalRun found) {
  const auto run = std::make_shared<const tasks::ModalRun>(std::move(found));
  return {.status = name(run->fit.status),
          .message = run->fit.message,
          .usable = is_usable(run->fit.status),
          .json = [run] { return report::modal_json(*run); },
          .text = [run] { return report::modal_text(*run); },
          .csv = [run] { return report::modes_csv(*run); },
          .page = [run](const ident::Control&) { return report::modal_page(*run); },
          .frfs = [run](const ident::Control&) { return run->regenerated; }};
}

Outcome modalfit_of(const std::vector<std::string>& files, const frf::OpenOptions& open, const ModalTask& task,
                    const py::object& progress) {
  modalfit::FitOptions options = options_of(task);
  return watched(progress, 0, [files = paths_of(files), open, options](const ident::Control& control) {
    modalfit::FitOptions watching = options;
    watching.interrupted = control.interrupted;
    watching.abandoned = lasting(control.interrupted, patience);
    watching.progress = [&control](const char* stage) { control.progress(stage, 0, 0); };
    return outcome_of(tasks::run_modal_files(files, open, watching));
  });
}

Outcome outcome_of(tasks::LoadingCurveResult found) {
  const auto result = std::make_shared<const tasks::LoadingCurveResult>(std::move(found));
  const bool usable = tasks::some_usable(*result);
  return {.status = usable ? "ok" : "not_usable",
          .message = usable || result->fits.empty() ? "" : result->fits.front().message,
          .usable = usable,
          .json = [result] { return report::loading_curve_json(*result); },
          .text = [result] { return report::loading_curve_text(*result); },
          .csv = [result] { return report::loading_curve_csv(*result); },
          .page = [result](const ident::Control&) { return report::loading_curve_page(*result); }};
}

tasks::FittingWatch watch_of(const ident::Control& control, SoFar& so_far) {
  const auto keep = [&so_far](const tasks::LoadingCurveResult& laws) {
    so_far.put([laws] {
      Outcome out = outcome_of(laws);
      out.message = "Interrupted: the laws that were fitted so far.";
      return out;
    });
  };
  return {control.interrupted, [&control](const std::string& stage) { control.progress(stage.c_str(), 0, 0); }, keep};
}

Outcome loading_curve(const tasks::LoadingCurveTask& task, const py::object& progress) {
  tasks::check(task);
  return watched(progress, 0, [task](const ident::Control& control, SoFar& so_far) {
    return outcome_of(tasks::fit_loading_curves(task, watch_of(control, so_far)));
  });
}

/// Curves in memory: name, displacements, forces of each.
Outcome loading_curve_arrays(const std::vector<std::tuple<std::string, py::buffer, py::buffer>>& curves,
                             const tasks::LoadingCurveTask& task, const py::object& progress) {
  tasks::LoadingCurveData data;
  for (const auto& [name, displacement, force] : curves) {
    data.curves.push_back(friction::loading_curve(name, {doubles_of(displacement), doubles_of(force)}));
  }
  return watched(progress, 0, [task, data](const ident::Control& control, SoFar& so_far) {
    return outcome_of(tasks::fit_loading_curves(data, task, watch_of(control, so_far)));
  });
}

void bind_loading_curve(py::module_& module) {
  using Task = tasks::LoadingCurveTask;
  py::class_<Task>(module, "LoadingCurveTask")
      .def(py::init<>())
      .def_property(
          "files", [](const Task& of) { return names_of(of.files); },
          [](Task& of, const std::vector<std::string>& files) { of.files = paths_of(files); })
      .def_readwrite("displacement", &Task::displacement)
      .def_readwrite("force", &Task::force)
      .def_readwrite("time", &Task::time)
      .def_readwrite("energy", &Task::energy)
      .def_readwrite("stiffness", &Task::stiffness)
      .def_readwrite("damping", &Task::damping)
      .def_readwrite("unit", &Task::unit)
      .def_readwrite("force_unit", &Task::force_unit)
      .def_readwrite("time_unit", &Task::time_unit)
      .def_readwrite("sign", &Task::sign)
      .def_readwrite("velocity", &Task::velocity)
      .def_readwrite("kind", &Task::kind)
      .def_readwrite("law", &Task::laws)
      .def_readwrite("ring", &Task::ring)
      .def_readwrite("normal_load", &Task::normal_loads)
      .def_readwrite("limit", &Task::limit)
      .def_readwrite("friction_coefficient", &Task::friction_coefficient)
      .def_readwrite("shared", &Task::shared)
      .def_readwrite("specimen_stiffness", &Task::specimen_stiffness)
      .def_property(
          "specimen", [](const Task& of) { return of.specimen.string(); },
          [](Task& of, const std::string& file) { of.specimen = file; })
      .def_readwrite("weighting", &Task::weighting)
      .def_readwrite("minimiser", &Task::minimiser);
  module.def("loading_curve", loading_curve);
  module.def("loading_curve_arrays", loading_curve_arrays);
}

void bind_modalfit(py::module_& module) {
  py::class_<ModalTask>(module, "ModalTask")
      .def(py::init<>())
      .def_readwrite("range", &ModalTask::range)
      .def_readwrite("modes", &ModalTask::modes)
      .def_readwrite("poles", &ModalTask::poles)
      .def_readwrite("real", &ModalTask::real)
      .def_readwrite("damping", &ModalTask::damping);
  module.def("modalfit", modalfit_of);
}

}  // namespace

void bind_file_tasks(py::module_& module) {
  bind_modalfit(module);
  bind_loading_curve(module);
}

}  // namespace jointid::python

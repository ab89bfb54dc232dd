#include "python/file_tasks.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "friction/curve/curve.hpp"
#include "python/outcome.hpp"
#include "python/watch.hpp"
#include "report/frf/frf_page.hpp"
#include "report/frf/frf_text.hpp"
#include "report/loading_curve/loading_curve_page.hpp"
#include "report/loading_curve/loading_curve_text.hpp"
#include "report/modalfit/modal_page.hpp"
#include "report/modalfit/modal_text.hpp"
#include "report/pod/pod_page.hpp"
#include "report/pod/pod_report.hpp"
#include "tasks/frf/run_frf.hpp"
#include "tasks/loading_curve/loading_curve_fit.hpp"
#include "tasks/modalfit/modal_run.hpp"
#include "tasks/pod/run_pod.hpp"

namespace jointid::python {
namespace {

namespace py = pybind11;
using Paths = std::vector<std::filesystem::path>;

Paths paths_of(const std::vector<std::string>& names) { return {names.begin(), names.end()}; }

std::vector<std::string> names_of(const Paths& paths) {
  std::vector<std::string> names;
  for (const auto& path : paths) names.push_back(path.string());
  return names;
}

/// What Python hands over as one contiguous run of doubles, copied.
std::vector<double> doubles(const py::buffer& buffer) {
  const py::buffer_info info = buffer.request();
  if (info.format != "d") refuse("an array is not of float64", "numpy.ascontiguousarray(array, float) makes one");
  const auto* const begin = static_cast<const double*>(info.ptr);
  return {begin, begin + info.size};
}

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
  return {.status = modalfit::name(run->fit.status),
          .message = run->fit.message,
          .usable = modalfit::is_usable(run->fit.status),
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

tasks::FittingWatch watch_of(const ident::Control& control) {
  return {control.interrupted, [&control](const std::string& stage) { control.progress(stage.c_str(), 0, 0); }, {}};
}

Outcome loading_curve(const tasks::LoadingCurveTask& task, const py::object& progress) {
  tasks::check(task);
  return watched(progress, 0, [task](const ident::Control& control) {
    return outcome_of(tasks::fit_loading_curves(task, watch_of(control)));
  });
}

/// Curves in memory: name, displacements, forces of each.
Outcome loading_curve_arrays(const std::vector<std::tuple<std::string, py::buffer, py::buffer>>& curves,
                             const tasks::LoadingCurveTask& task, const py::object& progress) {
  tasks::LoadingCurveData data;
  for (const auto& [name, displacement, force] : curves) {
    data.curves.push_back(friction::loading_curve(name, {doubles(displacement), doubles(force)}));
  }
  return watched(progress, 0, [task, data](const ident::Control& control) {
    return outcome_of(tasks::fit_loading_curves(data, task, watch_of(control)));
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
      .def_readwrite("minimiser", &Task::minimiser)
      .def_readwrite("global_search", &Task::global);
  module.def("loading_curve", loading_curve);
  module.def("loading_curve_arrays", loading_curve_arrays);
}

Outcome outcome_of(tasks::FrfRun made) {
  const auto run = std::make_shared<const tasks::FrfRun>(std::move(made));
  return {.status = {},
          .message = {},
          .json = [run] { return report::frf_json(*run, std::nullopt); },
          .text = [run] { return report::frf_text(*run); },
          .csv = [run] { return report::stretches_csv(*run); },
          .page = [run](const ident::Control&) { return report::frf_page(*run); },
          .frfs = [run](const ident::Control&) { return run->made.set; }};
}

Outcome frf_of(const tasks::FrfTask& task, const py::object& progress) {
  return watched(progress, 0, [task](const ident::Control& control) { return outcome_of(tasks::run_frf(task, control)); });
}

std::vector<frf::Dof> parsed(const std::vector<std::string>& names) {
  std::vector<frf::Dof> dofs;
  for (const std::string& name : names) dofs.push_back(frf::Dof::parse(name));
  return dofs;
}

/// A property of a part of the task.
template <class Get>
auto part(Get get) {
  using Value = std::remove_reference_t<decltype(get(std::declval<tasks::FrfTask&>()))>;
  return std::pair{[get](tasks::FrfTask& of) { return Value(get(of)); },
                   [get](tasks::FrfTask& of, const Value& to) { get(of) = to; }};
}

void bind_frf(py::module_& module) {
  using Task = tasks::FrfTask;
  py::class_<Task> task(module, "FrfTask");
  task.def(py::init<>())
      .def_property(
          "files", [](const Task& of) { return names_of(of.files); },
          [](Task& of, const std::vector<std::string>& files) { of.files = paths_of(files); })
      .def_property(
          "channel", [](const Task& of) { return of.read.channels.size(); },
          [](Task& of, const std::vector<std::string>& texts) {
            of.read.channels.clear();
            for (const std::string& text : texts) of.read.channels.push_back(records::parse_channel(text));
          })
      .def_property(
          "reference", [](const Task& of) { return frf::names(of.references); },
          [](Task& of, const std::vector<std::string>& names) { of.references = parsed(names); })
      .def_property(
          "window", [](const Task& of) { return static_cast<int>(of.segments.window); },
          [](Task& of, const std::string& word) {
            of.segments.window = static_cast<frf::Window>(find_word(word, {"rectangular", "hann"}, "window of segments"));
          })
      .def_property(
          "estimator", [](const Task& of) { return records::name(of.options.estimator); },
          [](Task& of, const std::string& word) { of.options.estimator = records::parse_estimator(word); })
      .def_property(
          "variances", [](const Task& of) { return of.options.noise == records::NoiseFrom::scatter ? "scatter" : "residuals"; },
          [](Task& of, const std::string& word) { of.options.noise = records::parse_noise_from(word); })
      .def_readwrite("shaker", &Task::shaker)
      .def_readwrite("block", &Task::block_s);
  const auto add = [&task](const char* name, const auto& property) { task.def_property(name, property.first, property.second); };
  add("time", part([](Task& of) -> std::string& { return of.read.time; }));
  add("rate", part([](Task& of) -> std::optional<double>& { return of.read.rate_hz; }));
  add("pretrigger", part([](Task& of) -> double& { return of.options.hammer.pretrigger_s; }));
  add("trigger", part([](Task& of) -> double& { return of.options.hammer.trigger; }));
  add("second_blow", part([](Task& of) -> double& { return of.options.hammer.second_peak; }));
  add("force_window", part([](Task& of) -> std::optional<double>& { return of.options.force_window_s; }));
  add("exponential", part([](Task& of) -> std::optional<double>& { return of.options.decay_time_s; }));
  add("overlap", part([](Task& of) -> double& { return of.segments.overlap; }));
  add("remove_mean", part([](Task& of) -> bool& { return of.options.remove_mean; }));
  add("reject", part([](Task& of) -> std::vector<std::size_t>& { return of.options.reject; }));
  add("keep_faulty", part([](Task& of) -> bool& { return of.options.keep_faulty; }));
  add("highest", part([](Task& of) -> double& { return of.options.highest_hz; }));
  module.def("frf", frf_of);
}

Outcome outcome_of(tasks::PodResult found) {
  const auto result = std::make_shared<const tasks::PodResult>(std::move(found));
  return {.status = {},
          .message = {},
          .json = [result] { return report::pod_json(*result); },
          .text = [result] { return report::pod_text(*result); },
          .csv = [result] { return report::pod_csv(*result); },
          .page = [result](const ident::Control&) { return report::pod_page(*result); }};
}

Outcome pod_of(const tasks::PodTask& task, std::size_t threads, const py::object& progress) {
  tasks::PodTask asked = task;
  asked.threads = threads;
  tasks::check(asked);
  return watched(progress, threads,
                 [asked](const ident::Control& control) { return outcome_of(tasks::run_pod(asked, control)); });
}

/// Samples in memory [T, m], of named channels with units.
Outcome pod_array(const py::buffer& samples, const std::vector<std::string>& names, const std::vector<std::string>& units,
                  const tasks::PodTask& task, const py::object& progress) {
  tasks::check(task);
  const std::vector<double> numbers = doubles(samples);
  return watched(progress, 0, [numbers, names, units, task](const ident::Control&) {
    const std::size_t channels = names.size();
    std::size_t done = 0;
    const auto next = [&](std::span<double> rows) {
      const std::size_t count = std::min(rows.size() / channels, (numbers.size() - done) / channels);
      std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(done), count * channels, rows.begin());
      done += count * channels;
      return count;
    };
    tasks::PodRecord record{names, units, 0, series::record_triangle(channels, next)};
    return outcome_of(tasks::run_pod(task, std::move(record)));
  });
}

void bind_pod(py::module_& module) {
  using Task = tasks::PodTask;
  py::class_<Task>(module, "PodTask")
      .def(py::init<>())
      .def_property(
          "files", [](const Task& of) { return names_of(of.files); },
          [](Task& of, const std::vector<std::string>& files) { of.files = paths_of(files); })
      .def_readwrite("channels", &Task::channels)
      .def_readwrite("mass", &Task::mass)
      .def_readwrite("stiffness", &Task::stiffness)
      .def_readwrite("compare", &Task::compare)
      .def_readwrite("keep_mean", &Task::keep_mean);
  module.def("pod", pod_of);
  module.def("pod_array", pod_array);
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
  bind_frf(module);
  bind_pod(module);
}

}  // namespace jointid::python

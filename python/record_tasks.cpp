#include "python/record_tasks.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

#include "base/control.hpp"
#include "base/error.hpp"
#include "python/arrays.hpp"
#include "python/conversions.hpp"
#include "python/outcome.hpp"
#include "python/watch.hpp"
#include "report/frf/frf_page.hpp"
#include "report/frf/frf_text.hpp"
#include "report/pod/pod_page.hpp"
#include "report/pod/pod_report.hpp"
#include "tasks/frf/run_frf.hpp"
#include "tasks/pod/run_pod.hpp"

namespace jointid::python {
namespace {

namespace py = pybind11;

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
          [](Task& of, const py::object& names) { of.references = dofs_of(names); })
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
Outcome pod_array(const py::object& samples, const std::vector<std::string>& names, const std::vector<std::string>& units,
                  const tasks::PodTask& task, const py::object& progress) {
  tasks::check(task);
  return watched(progress, 0, [kept = kept_doubles(samples, "record"), names, units, task](const ident::Control& control) {
    const std::span<const double> numbers = *kept;
    const std::size_t channels = names.size();
    std::size_t done = 0;
    const auto next = [&](std::span<double> rows) {
      stop_if(control.interrupted);
      control.progress("reading samples", done / channels, numbers.size() / channels);
      const std::size_t count = std::min(rows.size() / channels, (numbers.size() - done) / channels);
      std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(done), count * channels, rows.begin());
      done += count * channels;
      return count;
    };
    tasks::PodRecord record{names, units, 0, oscillation::record_triangle(channels, next)};
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

}  // namespace

void bind_record_tasks(py::module_& module) {
  bind_frf(module);
  bind_pod(module);
}

}  // namespace jointid::python

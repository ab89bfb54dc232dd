#include "python/scene_tasks.hpp"

#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "python/arrays.hpp"
#include "python/identify.hpp"
#include "python/lines.hpp"
#include "python/predict.hpp"
#include "python/sets.hpp"
#include "python/trials.hpp"
#include "python/watch.hpp"
#include "scene/kind.hpp"
#include "scene/text.hpp"

namespace jointid::python {
namespace {

namespace py = pybind11;

/// One of its texts, or None.
py::object text_of(const std::function<std::string()>& make) {
  if (!make) return py::none();
  std::string text;
  {
    const py::gil_scoped_release release;
    text = make();
  }
  return py::str(text);
}

void bind_outcome(py::module_& module) {
  py::class_<Outcome, std::shared_ptr<Outcome>>(module, "Outcome")
      .def_readonly("status", &Outcome::status)
      .def_readonly("message", &Outcome::message)
      .def_readonly("usable", &Outcome::usable)
      .def("json", [](const Outcome& of) { return text_of(of.json); })
      .def("text", [](const Outcome& of) { return text_of(of.text); })
      .def("csv", [](const Outcome& of) { return text_of(of.csv); })
      .def(
          "page",
          [](const Outcome& of, const py::object& progress) -> py::object {
            if (!of.page) return py::none();
            return py::str(watched(progress, 0, of.page));
          },
          py::arg("progress"))
      .def(
          "frfs",
          [](const Outcome& of, const py::object& progress) -> py::object {
            if (!of.frfs) return py::none();
            return dict_of(watched(progress, 0, of.frfs));
          },
          py::arg("progress"));
}

/// How Python calls a command: the scene's text and file, the threads (0: all cores), what is told of the progress, and its
/// options.
template <class Run>
Outcome run_scene(const std::string& text, const std::string& file, std::size_t threads, const py::object& progress,
                  const Run& run) {
  if constexpr (std::is_invocable_v<Run, const SceneText&, const ident::Control&, SoFar&>) {
    return watched(progress, threads, [scene = SceneText{text, file}, run](const ident::Control& control, SoFar& so_far) {
      return run(scene, control, so_far);
    });
  } else {
    return watched(progress, threads,
                   [scene = SceneText{text, file}, run](const ident::Control& control) { return run(scene, control); });
  }
}

template <class... Kept>
void bind_plain(py::module_& module, const char* name, Outcome (*run)(const SceneText&, const ident::Control&, Kept&...)) {
  module.def(name, [run](const std::string& text, const std::string& file, std::size_t threads, const py::object& progress) {
    return run_scene(text, file, threads, progress, run);
  });
}

Outcome run_bound(const std::string& text, const std::string& file, std::size_t threads, const py::object& progress,
                  const py::object& candidates) {
  return run_scene(text, file, threads, progress,
                   [dofs = dofs_of(candidates)](const SceneText& scene, const ident::Control& control, SoFar& so_far) {
                     return bound(scene, dofs, control, so_far);
                   });
}

Outcome run_study(const std::string& text, const std::string& file, std::size_t threads, const py::object& progress,
                  std::size_t trials, std::uint64_t seed, const std::string& out, bool resume) {
  return run_scene(text, file, threads, progress,
                   [task = StudyTask{trials, seed, out, resume}](const SceneText& scene, const ident::Control& control) {
                     return study(scene, task, control);
                   });
}

Outcome run_compare(const std::string& text, const std::string& file, std::size_t threads, const py::object& progress,
                    const CompareTask& task) {
  return run_scene(text, file, threads, progress,
                   [task](const SceneText& scene, const ident::Control& control, SoFar& so_far) {
                     return compare(scene, task, control, so_far);
                   });
}

Outcome run_couple(const std::string& text, const std::string& file, std::size_t threads, const py::object& progress,
                   const std::string& out, bool bounds) {
  return run_scene(text, file, threads, progress, [out, bounds](const SceneText& scene, const ident::Control& control) {
    return couple(scene, out, bounds, control);
  });
}

Outcome run_decouple(const std::string& text, const std::string& file, std::size_t threads, const py::object& progress,
                     const std::string& out) {
  return run_scene(text, file, threads, progress,
                   [out](const SceneText& scene, const ident::Control& control) { return decouple(scene, out, control); });
}

py::dict virtual_points(const std::string& text, const std::string& file, const std::string& path) {
  return dict_of(watched(py::none(), 0, [scene = SceneText{text, file}, path](const ident::Control&) {
    return at_virtual_points(scene, path);
  }));
}

void bind_compare_task(py::module_& module) {
  py::class_<CompareTask>(module, "CompareTask")
      .def(py::init<>())
      .def_readwrite("trials", &CompareTask::trials)
      .def_readwrite("seed", &CompareTask::seed)
      .def_readwrite("methods", &CompareTask::methods)
      .def_readwrite("equations", &CompareTask::equations)
      .def_readwrite("weightings", &CompareTask::weightings)
      .def_readwrite("deltas", &CompareTask::deltas)
      .def_readwrite("solvers", &CompareTask::solvers)
      .def_readwrite("regenerate", &CompareTask::regenerate);
}

}  // namespace

void bind_scene_tasks(py::module_& module) {
  bind_outcome(module);
  bind_compare_task(module);
  bind_plain(module, "solve", solve);
  bind_plain(module, "check", check);
  bind_plain(module, "plan", plan);
  bind_plain(module, "equivalent", equivalent);
  bind_plain(module, "response", response_of);
  bind_plain(module, "response_ways", response_ways);
  bind_plain(module, "oscillate", oscillate);
  module.def("bound", run_bound);
  module.def("study", run_study);
  module.def("compare", run_compare);
  module.def("couple", run_couple);
  module.def("decouple", run_decouple);
  module.def("is_line_scene", [](const std::string& text, const std::string& file) { return scene::is_line_scene(text, file); });
  module.def("virtual_points", virtual_points);
  module.def("read_text", [](const std::string& file) { return py::bytes(scene::read_text(file)); });
}

}  // namespace jointid::python

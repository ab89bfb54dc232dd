#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "gui/plot/curve.hpp"
#include "gui/work/worker.hpp"
#include "ident/plan/plan.hpp"
#include "ident/result/solution.hpp"
#include "report/result/kept_run.hpp"
#include "tasks/bound_report.hpp"
#include "tasks/regenerate.hpp"
#include "tasks/worth.hpp"

namespace jointid::gui {

/// A solution, with the plan that it came from: both belong to the thread that solves.
struct Solved {
  std::shared_ptr<ident::Plan> plan;  ///< none of a kept run before it is asked for
  ident::Solution solution;
  std::string name;  ///< "2: likelihood"
  std::vector<tasks::WorthAnswer> worth{};  ///< none of a run that was interrupted
  tasks::UnknownsByIteration iterations{};  ///< of methods that iterate
  std::string made{};                       ///< "2026-11-30T17:31:02"
  std::string scene_text{};                 ///< empty where the text is not known
  std::filesystem::path scene_file{};       ///< paths of the text are relative to its folder
  std::vector<report::RunInput> inputs{};   ///< as they were read
  std::vector<std::string> changed{};       ///< inputs that are not as they were, of a kept run
  QString kept{};                           ///< the file in which it is kept; empty: in none
};

/// Size and time of a file; zeros where there is none.
report::RunInput input_as_it_is(const std::string& file);

/// Whether a plan needs headers only, of files that are not large.
bool is_quick_to_plan(const ident::Scene& scene);

/// Unknowns of the joints of a scene, as far as they are known without its files: 0 where these have to be asked.
std::size_t unknowns_of(const ident::Scene& scene);

/// The files that no output may replace; none without a scene.
std::vector<std::filesystem::path> inputs_of(const std::optional<ident::Scene>& scene);

/// Plans and solves as `jointid solve` does. Interrupted, it gives the best values so far, marked as the command marks them;
/// throws Interrupted where there are none, and InputError.
Solved solve_scene(const ident::Scene& scene, const Worker::Watch& watch);

/// As `jointid plan --bound --candidates …`. Interrupted, it says so in what it gives. Throws InputError for scenes without a
/// joint to assume.
tasks::BoundReport predict_bound(const ident::Scene& scene, const std::vector<frf::Dof>& candidates, const Worker::Watch& watch);

/// What `jointid solve --json` writes of it, but for run times.
std::string json_of(const Solved& solved);

/// An FRF of the assembly as measured and as the joint of a solution gives it, and the error between them.
struct Overlay {
  std::vector<Curve> curves;
  std::optional<double> error_db;  ///< rms over lines
};

/// Lines of the plan that the fit takes for outliers, those with the largest χ²; none for methods that know nothing of it.
std::vector<double> outlying_hz(const Solved& solved);

/// The page that `jointid solve --report` writes, but for run times. Throws Interrupted.
std::string report_of(const Solved& solved, const Worker::Watch& watch);

/// What the joint of another run gives, under its name, where its assembly has the FRF.
void add_regenerated(Overlay& overlay, const Solved& other, const tasks::FrfEntry& entry, const Worker::Watch& watch);

Overlay regenerate_frf(const Solved& solved, const tasks::FrfEntry& entry, const Worker::Watch& watch);

}  // namespace jointid::gui

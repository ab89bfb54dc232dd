#include "tasks/loading_curve/loading_curve_task.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/text.hpp"
#include "friction/fit/fit_start.hpp"
#include "friction/law/arrangement.hpp"
#include "friction/law/laws.hpp"

namespace jointid::tasks {
namespace {

[[noreturn]] void fail(const char* option, std::string problem, std::string remedy) {
  throw InputError({ErrorKind::usage, "", option, std::move(problem), std::move(remedy)});
}

void check_named(const std::string& law) {
  try {
    (void)friction::law_to_fit(law);
  } catch (const InputError& error) {
    fail("--law", error.parts().problem, "jointid loading-curve --help lists the laws");
  }
}

void check_laws(const LoadingCurveTask& task) {
  const std::vector<std::string> valid = friction::fitted_laws();
  for (const std::string& law : task.laws) {
    if (law == "all" || std::ranges::find(valid, law) != valid.end()) continue;
    if (friction::is_arrangement(law) ||
        std::ranges::find(friction::named_laws(), law, &friction::Law::name) != friction::named_laws().end()) {
      check_named(law);
      continue;
    }
    const std::string near = nearest_word(law, valid);
    fail("--law", "'" + law + "' is no law", (near.empty() ? "" : "did you mean " + near + "? ") + "all: " + comma_list(valid));
  }
}

void check_columns(const LoadingCurveTask& task) {
  const bool series = !task.energy.empty() || !task.stiffness.empty() || !task.damping.empty();
  if (series && !task.force.empty())
    fail("--force", "an amplitude series has no forces", "leave --force or the other columns out");
  if (!task.energy.empty() && !task.stiffness.empty())
    fail("--energy", "both energies and stiffnesses are named", "fit one of them");
  if (task.stiffness.empty() != task.damping.empty())
    fail("--stiffness", "equivalents need both", "name --stiffness and --damping");
  if (series && (task.velocity || task.specimen_stiffness || !task.specimen.empty())) {
    fail("--displacement", "an amplitude series has no record to integrate or correct", "leave --velocity and --specimen out");
  }
  if (series && (task.sign != "auto" || task.kind != "auto"))
    fail(task.sign != "auto" ? "--sign" : "--kind", "an amplitude series has neither signs nor cycles", "leave it out");
  if (!task.energy.empty() && !task.force_unit.empty())
    fail("--force-unit", "an amplitude series of energies has no forces; energies are J", "leave it out");
  if (!task.velocity && !(task.time.empty() && task.time_unit.empty()))
    fail(task.time.empty() ? "--time-unit" : "--time", "no time is needed without --velocity",
         "leave it out, or give --velocity");
}

bool is_positive(double value) { return std::isfinite(value) && value > 0.0; }

void check_numbers(const LoadingCurveTask& task) {
  if (task.limit && !is_positive(*task.limit)) fail("--limit", "it is not positive", "give a force, N");
  if (task.limit && task.friction_coefficient) fail("--limit", "does not go with --friction-coefficient", "leave one out");
  if (task.friction_coefficient && task.normal_loads.empty())
    fail("--friction-coefficient", "needs normal loads", "give --normal-load");
  for (const double load : task.normal_loads) {
    if (!is_positive(load)) fail("--normal-load", "a load is not positive", "give forces, N");
  }
  if (task.normal_loads.size() > 1 && task.normal_loads.size() != task.files.size()) {
    fail("--normal-load", std::to_string(task.normal_loads.size()) + " loads for " + std::to_string(task.files.size()) + " files",
         "give one for all files or one for each");
  }
  if (!task.ring.empty() && !(task.ring[0] >= 0.0 && task.ring[1] > task.ring[0] && is_positive(task.ring[1]))) {
    fail("--ring", "the radii do not increase", "give inner and outer radius, m, e.g. 0.0255,0.038");
  }
  if (task.specimen_stiffness && !is_positive(*task.specimen_stiffness))
    fail("--specimen-stiffness", "it is not positive", "give it in N/m");
  if (task.specimen_stiffness && !task.specimen.empty())
    fail("--specimen", "does not go with --specimen-stiffness", "leave one out");
}

}  // namespace

void check(const LoadingCurveTask& task) {
  check_laws(task);
  check_columns(task);
  check_numbers(task);
}

}  // namespace jointid::tasks

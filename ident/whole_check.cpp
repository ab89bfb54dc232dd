#include "ident/whole_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "base/error.hpp"
#include "base/statistics.hpp"
#include "base/text.hpp"
#include "frf/set/frf_system.hpp"
#include "ident/check/check.hpp"
#include "ident/check/rest.hpp"
#include "ident/check/test/checked_file.hpp"
#include "ident/identify.hpp"
#include "ident/likelihood/findings/variance_sources.hpp"
#include "ident/plan/expected_time.hpp"
#include "ident/plan/data_source.hpp"
#include "ident/scene/variance_origin.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t fitted_frfs = 2500, least_fitted = 32, most_fitted = 96;
constexpr double moment = 0.4;          ///< s of the reference machine
constexpr double least_misfit = 1.005;  ///< χ² over degrees of freedom

std::size_t frfs_of(const frf::FrfSystem& system) {
  std::size_t sum = 0;
  for (std::size_t s = 0; s < system.source_count(); ++s) sum += system.source(s).header().entries();
  return sum;
}

Scene likelihood_of(const Scene& scene) {
  Scene out = scene;
  out.identify.automatic = false;
  out.identify.bootstrap = 0;
  if (scene.identify.method != Method::likelihood) {
    out.identify.method = Method::likelihood;
    out.identify.solver = Solver::automatic;
  }
  return out;
}

bool knows_variances(const Plan& plan) {
  return std::ranges::none_of(variance_sources(plan), [](const VarianceSource& file) {
    return file.origin == phrase(VarianceOrigin::scatter) || file.origin == phrase(VarianceOrigin::noise_model);
  });
}

/// As many lines as are fitted within a moment, by counted operations, so that the same is found on every machine.
std::size_t affordable_lines(const Plan& plan) {
  const double seconds = expected_seconds(plan.cost, 1);
  if (!(seconds > 0.0)) return least_fitted;
  const double lines = moment * static_cast<double>(plan.lines.size()) / seconds;
  return static_cast<std::size_t>(std::clamp(lines, static_cast<double>(least_fitted), static_cast<double>(most_fitted)));
}

/// Plans a scene on its files, or on sets in memory.
using MakePlan = std::function<std::unique_ptr<Plan>(const Scene& scene)>;

/// Some lines, evenly spread; null where the scene is too large, or variances are not known.
std::unique_ptr<Plan> small_plan(Scene scene, const MakePlan& plan_of) {
  auto plan = plan_of(scene);
  if (!knows_variances(*plan)) return nullptr;
  if (frfs_of(*plan->substructures) + frfs_of(*plan->assembly) > fitted_frfs || !plan->regenerated.empty()) return nullptr;
  const std::size_t lines = affordable_lines(*plan);
  if (plan->lines.size() <= lines) return plan;
  const double first = plan->lines.front().frequency_hz, last = plan->lines.back().frequency_hz;
  scene.frequency.range_hz = {first, last};
  scene.frequency.step_hz = (last - first) / static_cast<double>(lines - 1);
  return plan_of(scene);
}

Suspect no_joint_explains(const Plan& plan, double ratio, const ChiSquare& chi_square) {
  return {.kind = SuspectKind::nonlinear,
          .file = "",
          .dofs = {},
          .evidence = "each file agrees with itself, but no joint of this scene explains the FRFs: they are off by " +
                      digits(std::sqrt(ratio)) + " times their standard errors (χ² over degrees of freedom " +
                      digits(ratio, "%.3g") + ")" + worst_band(plan.lines, chi_square.by_line) + ". " + other_causes(plan.scene),
          .confidence = 0.6,
          .remedy = ""};
}

/// Lines that the fit sets aside, beyond what chance makes of the worst.
std::optional<Suspect> set_aside(const Plan& plan, const ChiSquare& chi_square) {
  constexpr double far = 6.0;  // χ² over its expectation
  const auto tested =
      static_cast<double>(std::ranges::count_if(chi_square.by_line, [](double each) { return !std::isnan(each); }));
  const double freedom = std::max(1.0, chi_square.degrees_of_freedom / std::max(1.0, tested));
  const double limit = std::max(far, chi_square_quantile(freedom, 5.0) / freedom);
  std::string at, ranges;
  std::size_t count = 0;
  double worst = 0.0;
  for (std::size_t l = 0; l < std::min(plan.lines.size(), chi_square.by_line.size()); ++l) {
    if (!(chi_square.by_line[l] > limit)) continue;
    const std::string hz = digits(plan.lines[l].frequency_hz, "%.9g");
    if (count < 6) at += (count > 0 ? ", " : "") + hz;
    ranges += (count > 0 ? ", [" : "[") + hz + ", " + hz + "]";
    worst = std::max(worst, chi_square.by_line[l]);
    ++count;
  }
  if (count == 0 || 3 * count > chi_square.by_line.size()) return std::nullopt;
  return Suspect{
      .kind = SuspectKind::outlier,
      .file = "",
      .dofs = {},
      .evidence = std::to_string(count) + " of " + std::to_string(chi_square.by_line.size()) + " lines, at " + at +
                  (count > 6 ? " and more" : "") + " Hz, are off by up to " + digits(std::sqrt(worst)) +
                  " times their standard errors, and a fit sets them aside: a dropout, an overload, or no excitation there",
      .confidence = 0.7,
      .remedy = "[frequency]\nexclude = [" + ranges + "]"};
}

/// Empty where nothing was fitted.
std::optional<std::vector<Suspect>> suspects_of_fit(const Scene& scene, const MakePlan& plan_of, const Control& control) {
  try {
    const auto plan = small_plan(likelihood_of(scene), plan_of);
    if (!plan) return std::nullopt;
    const Solution fit = solve(*plan, {.threads = control.threads, .progress = {}, .interrupted = control.interrupted});
    if (!fit.fit.chi_square || !(is_usable(fit.status) || fit.status == Status::poor_fit)) return std::nullopt;
    const ChiSquare& chi_square = *fit.fit.chi_square;
    const double ratio = chi_square.value / std::max(1.0, chi_square.degrees_of_freedom);
    std::vector<Suspect> found;
    if (auto lines = set_aside(*plan, chi_square)) found.push_back(std::move(*lines));
    if (ratio > std::max(chi_square.likely, least_misfit)) {
      found.push_back(no_joint_explains(*plan, ratio, chi_square));
      return found;
    }
    for (Suspect suspect : fit.suspects) {
      suspect.file = suspect.file.empty() ? "" : name_in_scene(scene, suspect.file);
      found.push_back(std::move(suspect));
    }
    return found;
  } catch (const InputError&) {
    return std::nullopt;  // solve says so
  }
}

/// A gain of a whole file that forces at the joint call for, whatever they are: the joint of the scene tells that better.
bool is_gain_of_file(const Suspect& suspect) {
  return suspect.kind == SuspectKind::gain && suspect.dofs.empty() && suspect.confidence < 0.8;
}

/// What each file says, and where that is nothing (or a gain of a whole file) what a fit says.
CheckResult with_fit(CheckResult result, const Scene& scene, const MakePlan& plan_of, const Control& control) {
  if (!std::ranges::all_of(result.suspects, is_gain_of_file)) return result;
  auto fitted = suspects_of_fit(scene, plan_of, control);
  if (!fitted) return result;
  const bool confirmed = std::ranges::any_of(*fitted, is_gain_of_file) && !result.suspects.empty();
  if (!confirmed) result.suspects = std::move(*fitted);
  result.verdict = result.suspects.empty() ? Verdict::clean : Verdict::suspicious;
  return result;
}

/// A system of sets that outlive it.
std::shared_ptr<frf::FrfSystem> system_of(const char* name, const std::vector<frf::FrfSet>& sets, frf::Composition composition,
                                          const Scene& scene) {
  Sources sources;
  for (const frf::FrfSet& set : sets) {
    frf::validate(set);
    sources.push_back(frf::from_shared(std::shared_ptr<const frf::FrfSet>(std::shared_ptr<void>(), &set)));
  }
  return std::make_shared<frf::FrfSystem>(name, std::move(sources), composition, scene.data.reciprocity);
}

}  // namespace

CheckResult check_whole(const Scene& scene, const Control& control) {
  const auto plan_of = [](const Scene& each) { return make_plan(each); };
  return with_fit(check_scene(scene, control), scene, plan_of, control);
}

CheckResult check_whole(const Scene& scene, const std::vector<frf::FrfSet>& substructures, const std::vector<frf::FrfSet>& assembly,
                        const Control& control) {
  const auto parts = [&] { return system_of("substructures", substructures, frf::Composition::uncoupled, scene); };
  const auto whole = [&] { return system_of("assembly", assembly, frf::Composition::merged, scene); };
  const auto plan_of = [&](const Scene& each) { return make_plan(each, parts(), whole()); };
  return with_fit(check_systems(scene, parts(), whole(), control), scene, plan_of, control);
}

}  // namespace jointid::ident

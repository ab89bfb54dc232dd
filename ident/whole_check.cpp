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
#include "ident/identify.hpp"
#include "ident/likelihood/findings/variance_sources.hpp"
#include "ident/plan/data_source.hpp"
#include "ident/scene/variance_origin.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t fitted_frfs = 2500, fitted_lines = 24;
constexpr double beyond = 1.5;  ///< χ² over degrees of freedom

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
    out.identify.solver = "auto";
  }
  return out;
}

bool knows_variances(const Plan& plan) {
  return std::ranges::none_of(variance_sources(plan), [](const VarianceSource& file) {
    return file.origin == phrase(VarianceOrigin::scatter) || file.origin == phrase(VarianceOrigin::noise_model);
  });
}

/// Plans a scene on its files, or on sets in memory.
using MakePlan = std::function<std::unique_ptr<Plan>(const Scene& scene)>;

/// Few lines, evenly spread; null where the scene is too large, or variances are not known.
std::unique_ptr<Plan> small_plan(Scene scene, const MakePlan& plan_of) {
  auto plan = plan_of(scene);
  if (!knows_variances(*plan)) return nullptr;
  if (frfs_of(*plan->substructures) + frfs_of(*plan->assembly) > fitted_frfs || !plan->regenerated.empty()) return nullptr;
  if (plan->lines.size() <= fitted_lines) return plan;
  const double first = plan->lines.front().frequency_hz, last = plan->lines.back().frequency_hz;
  scene.frequency.range_hz = {first, last};
  scene.frequency.step_hz = (last - first) / static_cast<double>(fitted_lines - 1);
  return plan_of(scene);
}

std::optional<Suspect> fit_suspect(const Scene& scene, const MakePlan& plan_of, const Control& control) {
  try {
    const auto plan = small_plan(likelihood_of(scene), plan_of);
    if (!plan) return std::nullopt;
    const Solution fit = solve(*plan, {.threads = control.threads,
                                       .progress = {},
                                       .interrupted = control.interrupted,
                                       .detail = Detail::estimates,
                                       .judgement = Judgement::none});
    if (!fit.fit.chi_square || fit.status != Status::ok) return std::nullopt;
    const double freedom = std::max(1.0, fit.fit.chi_square->degrees_of_freedom), ratio = fit.fit.chi_square->value / freedom;
    if (!(ratio > std::max(beyond, chi_square_quantile(freedom, 5.0) / freedom))) return std::nullopt;
    return Suspect{.kind = SuspectKind::nonlinear,
                   .file = "",
                   .dofs = {},
                   .evidence = "each file agrees with itself, but no joint of this scene explains the FRFs: they are off by " +
                               digits(std::sqrt(ratio)) + " times their standard errors (χ² over degrees of freedom " +
                               digits(ratio, "%.3g") + ")" + worst_band(plan->lines, fit.fit.chi_square->by_line) + ". " +
                               other_causes(scene),
                   .confidence = 0.6,
                   .remedy = ""};
  } catch (const InputError&) {
    return std::nullopt;  // solve says so
  }
}

/// Where data without a suspect are not explained by any joint of the scene, that is one.
CheckResult with_fit(CheckResult result, const Scene& scene, const MakePlan& plan_of, const Control& control) {
  if (!result.suspects.empty()) return result;
  if (auto suspect = fit_suspect(scene, plan_of, control)) {
    result.suspects.push_back(std::move(*suspect));
    result.verdict = Verdict::suspicious;
  }
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

#include "ident/automatic_method.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "base/error.hpp"
#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "ident/equations/linear_plan.hpp"
#include "ident/likelihood/data/systematic_plan.hpp"
#include "ident/plan/expected_time.hpp"
#include "ident/plan/prediction.hpp"
#include "ident/scene/variance_origin.hpp"

namespace jointid::ident {
namespace {

constexpr double longest = 120.0;  // s: a rig of 60 × 30 FRFs and 3,200 lines, whose intervals by Method One are many times as wide

bool has_solver(Method method, Solver solver) {
  const std::vector<Solver>& own = traits(method).solvers;
  return std::find(own.begin(), own.end(), solver) != own.end();
}

bool knows_variances(const Scene& scene, const frf::FrfSystem& system) {
  for (std::size_t s = 0; s < system.source_count(); ++s) {
    try {
      if (variance_origin(scene, system.source(s).header()) == VarianceOrigin::scatter) return false;
    } catch (const InputError&) {
      return false;
    }
  }
  return true;
}

struct Choice {
  Method method = Method::one;
  std::string why;
  bool is_certain = true;  ///< whatever it would cost, and whether it has equations or not
};

Choice wish(const Scene& scene, const frf::FrfSystem& substructures, const frf::FrfSystem& assembly) {
  const IdentifySection& identify = scene.identify;
  if (!identify.any_weighting) return {Method::one, "the scene names a weighting or a delta"};
  if (identify.solver != Solver::automatic) {
    for (const Method method : {Method::likelihood, Method::one, Method::newton}) {
      if (has_solver(method, identify.solver)) return {method, "it has the solver " + name(identify.solver)};
    }
  }
  if (!identify.priors.empty() || identify.bootstrap > 0) return {Method::likelihood, "the scene has priors or a bootstrap"};
  if (are_errors_unknown(scene.data)) return {Method::likelihood, "the scene has gains, masses or errors of models with priors"};
  if (!identify.start.empty() || identify.starts > 0) return {Method::likelihood, "the scene gives a start"};
  if (scene.data.regenerate.any()) return {Method::one, "errors of synthesised FRFs are not independent", false};
  if (!knows_variances(scene, substructures) || !knows_variances(scene, assembly)) {
    return {Method::one, "the variances of the FRFs are not known (of the files, [noise] or repeats)", false};
  }
  return {Method::likelihood, "the variances of the FRFs are known", false};
}

/// Rows by parts bear noise badly: of few unknowns the iterative methods make more.
bool is_small_by_parts(const Plan& plan) { return plan.why_by_parts && plan.columns->size() < least_unknowns_by_parts; }

std::unique_ptr<Plan> planned(Scene scene, const Choice& choice, const Planner& planner) {
  scene.identify.method = choice.method;
  scene.identify.automatic = false;
  auto plan = planner(scene);
  if (!choice.is_certain && is_small_by_parts(*plan)) throw InputError(*plan->why_by_parts);
  plan->chosen = "method " + name(choice.method) + ": " + choice.why;
  return plan;
}

/// Where Method One has no equation: the likelihood, else "newton"; `refused` where neither plans.
std::unique_ptr<Plan> plan_without_equations(const Scene& scene, const InputError& refused, bool likelihood_is_refused,
                                             const Planner& planner) {
  const std::string why = "Method One has no equation on these data (" + refused.parts().problem + ")";
  for (const Method method : {Method::likelihood, Method::newton}) {
    if (method == Method::likelihood && likelihood_is_refused) continue;
    try {
      return planned(scene, {method, why}, planner);
    } catch (const InputError&) {
      // The next one needs less.
    }
  }
  throw InputError(refused.parts());
}

}  // namespace

std::unique_ptr<Plan> plan_automatically(const Scene& scene, const frf::FrfSystem& substructures, const frf::FrfSystem& assembly,
                                         const Planner& planner) {
  Choice choice = wish(scene, substructures, assembly);
  if (choice.is_certain) return planned(scene, choice, planner);
  std::unique_ptr<Plan> slow;
  const bool asks_likelihood = choice.method == Method::likelihood;
  if (asks_likelihood) {
    try {
      slow = planned(scene, choice, planner);
      if (are_expected_within(longest, slow->cost)) return slow;
      choice.why = "the likelihood would take about " + digits(expected_seconds(slow->cost, 2)) +
                   " s on two cores of the reference machine (docs/cost.md)";
    } catch (const InputError& error) {
      choice.why = "the data do not allow the likelihood: " + error.parts().problem;
    }
  }
  choice.method = Method::one;
  try {
    return planned(scene, choice, planner);
  } catch (const InputError& refused) {
    if (!slow) return plan_without_equations(scene, refused, asks_likelihood, planner);
    slow->chosen = "method likelihood: Method One has no equation on these data; it takes about " +
                   digits(expected_seconds(slow->cost, 2)) + " s on two cores of the reference machine (docs/cost.md)";
    return slow;
  }
}

void choose_weighting(Plan& plan, const Control& control, RunTime& time) {
  LinearPlan* const linear = linear_plan(plan);
  const bool may_try = !plan.chosen.empty() && plan.scene.identify.any_weighting && linear != nullptr;
  if (!may_try || !plan.keeps_frfs || plan.predicted_responses.empty()) return;
  const Stopwatch watch(time.start);
  using enum weighting::Weighting;
  Control quick = control;
  quick.detail = Detail::estimates;
  quick.judgement = Judgement::none;
  quick.so_far = {};
  weighting::Weighting best = linear->spec.weighting;
  double least = std::numeric_limits<double>::infinity();
  for (const weighting::Weighting each : {wb, wbg, wbs, wa}) {
    linear->spec.weighting = each;
    Solution trial;
    plan.method->solve(plan, quick, trial);
    if (trial.bands.empty() || trial.status == Status::no_equations) continue;
    const DecibelError error = predict(plan, trial.bands, quick);
    const double rms = error.entries > 0 ? std::sqrt(error.sum_of_squares / static_cast<double>(error.entries)) : least;
    if (rms < least) std::tie(best, least) = std::pair(each, rms);
  }
  linear->spec.weighting = plan.scene.identify.weighting = best;
}

}  // namespace jointid::ident

#include "ident/identify.hpp"

#include <algorithm>
#include <cstdint>

#include "base/error.hpp"
#include "base/stopwatch.hpp"
#include "ident/automatic_method.hpp"
#include "ident/check/check.hpp"
#include "ident/check/real_frfs.hpp"
#include "ident/check/rest.hpp"
#include "ident/judgement/judge.hpp"
#include "ident/judgement/loose_joints.hpp"
#include "ident/judgement/tell_errors.hpp"
#include "ident/likelihood/data/systematic_plan.hpp"
#include "ident/modal_regeneration.hpp"
#include "ident/plan/data_source.hpp"
#include "ident/plan/expected_time.hpp"
#include "ident/plan/models_of_plan.hpp"
#include "ident/prepare_plan.hpp"
#include "ident/scene/scene_failure.hpp"
#include "ident/wild_lines.hpp"

namespace jointid::ident {
namespace {

/// A likelihood among the choices is that by parts: where it takes less than a minute, it comes before rows by parts, which bear noise
/// badly. Few unknowns do without a start by rows alone.
std::unique_ptr<Plan> plan_start(const Plan& plan, const StartChoices& choices) {
  constexpr double longest = 60.0;  // s
  Scene scene = plan.scene;
  scene.identify = {};
  for (restrictions::JointSpec& joint : scene.joints) joint.definite.clear();
  scene.couple_first = {};  // done already
  const bool may_go_by_parts = std::ranges::any_of(choices, [](const auto& choice) { return choice.first == Method::likelihood; });
  std::unique_ptr<Plan> rows;
  for (const auto& [method, equations] : choices) {
    if (method == Method::direct && rows && rows->columns->size() >= least_unknowns_by_parts) return rows;
    scene.identify.method = method;
    scene.identify.equations = equations;
    scene.identify.solver = method == Method::likelihood ? Solver::by_parts : Solver::automatic;
    try {
      auto start = make_plan(scene, plan.substructures, plan.assembly);
      if (method == Method::likelihood && rows && !are_expected_within(longest, start->cost)) return rows;
      if (!start->why_by_parts || !may_go_by_parts || method == Method::likelihood || plan.scene.identify.loose) return start;
      if (!rows) rows = std::move(start);
    } catch (const InputError&) {
      // The next one needs less.
    }
  }
  fail(plan.scene, "[identify] start", "the data allow no linear estimate to start from", "add start = { … } to [identify]");
}

constexpr const char* errors_taken_for_known =
    "Gains of [[data.gains]] are taken for 1, masses of [[data.masses]] for known and models for exact: only method "
    "\"likelihood\" estimates them.";

bool ignores_systematic_errors(const Scene& scene) {
  return scene.identify.method != Method::likelihood && are_errors_unknown(scene.data);
}

/// What the FRFs' variances do not say of their errors.
void warn_of_shared_errors(const Plan& plan, Solution& out) {
  if (!traits(plan.scene.identify.method).uses_variances) return;
  std::string which;
  if (!plan.scene.couple_first.pairs.empty() && !plan.method->carries_shared_errors()) which = "the FRFs of the coupled parts";
  if (!plan.regenerated.empty()) which += (which.empty() ? "" : " and ") + std::string("synthesised FRFs");
  if (which.empty()) return;
  out.warnings.push_back("The likelihood takes the errors of FRFs for independent; those of " + which +
                         " are not, so that standard errors and intervals are too small.");
}

/// What the short check of the data finds, in status and message.
void check_briefly(const Plan& plan, const Control& control, Solution& out) {
  if (control.detail != Detail::full || control.judgement != Judgement::data) return;
  const Stopwatch watch(out.runtime_s.check);
  out.check = quick_check(plan, control);
  tell_check(*out.check, out);
  if (std::ranges::find(out.check->notes, all_frfs_are_real) != out.check->notes.end())
    out.warnings.emplace_back(all_frfs_are_real);
  const auto is_unexplained = [](const Suspect& suspect) { return suspect.kind == SuspectKind::nonlinear; };
  if (out.status != Status::poor_fit || !std::ranges::all_of(out.check->suspects, is_unexplained)) return;
  const std::string band = out.fit.chi_square ? worst_band(plan.lines, out.fit.chi_square->by_line) : "";
  out.message += (band.empty() ? " " : " The misfit is" + band.substr(1) + ". ") + other_causes(plan.scene) + ".";
}

/// A plan like this one without some of its lines, on the same files; null where FRFs are synthesised or parts were coupled
/// before.
std::unique_ptr<Plan> plan_without(const Plan& plan, const std::vector<double>& lines_hz) {
  constexpr double rounding = 1e-9;
  if (!plan.regenerated.empty() || !plan.scene.couple_first.pairs.empty()) return nullptr;
  Scene scene = plan.scene;
  scene.identify.automatic = false;
  for (const double hz : lines_hz) scene.frequency.exclude_hz.push_back({hz * (1.0 - rounding), hz * (1.0 + rounding)});
  try {
    auto out = make_plan(scene, plan.substructures, plan.assembly);
    out->chosen = plan.chosen;
    out->models = plan.models;
    return out;
  } catch (const InputError&) {
    return nullptr;  // too few lines are left
  }
}

/// Values that no structure has would stop or ruin any estimate: their lines are left out of the plan.
WildLines leave_out_absurd_lines(Plan& plan, const Control& control) {
  if (control.detail != Detail::full || control.judgement != Judgement::data || control.shares.size() > 1) return {};
  WildLines wild = find_wild_lines(plan, control);
  if (wild.absurd_hz.empty()) return wild;
  if (auto without = plan_without(plan, wild.absurd_hz)) {
    plan = std::move(*without);
    for (std::string& each : wild.absurd) each += "; the line is left out";
  }
  wild.named.insert(wild.named.begin(), wild.absurd.begin(), wild.absurd.end());
  return wild;
}

void tell_wild_lines(const WildLines& wild, Solution& out) {
  if (wild.named.empty()) return;
  std::string text = "Wild values: " + wild.named.front();
  if (wild.named.size() > 1) text += ", and " + std::to_string(wild.named.size() - 1) + " more (`jointid info`)";
  tell(out, Status::doubtful, text + ". Put the file right, or leave the line out (exclude in [frequency]).");
}

}  // namespace

std::unique_ptr<Plan> make_plan(const Scene& scene) {
  std::vector<ModalRegeneration> regenerated;
  OpenedScene opened = open_scene(scene);
  const auto system_of = [&](const char* name, Sources sources, frf::Composition composition, bool by_modes) {
    if (by_modes) sources = regenerate_sources(std::move(sources), composition == frf::Composition::merged, scene, regenerated);
    return std::make_unique<frf::FrfSystem>(name, std::move(sources), composition, scene.data.reciprocity);
  };
  const Regeneration chosen = scene.data.regenerate;
  auto substructures =
      system_of("substructures", std::move(opened.substructures), frf::Composition::uncoupled, chosen.substructures);
  auto assembly = system_of("assembly", std::move(opened.assembly), frf::Composition::merged, chosen.assembly);
  auto plan = make_plan(scene, std::move(substructures), std::move(assembly));
  for (const ModalRegeneration& each : regenerated) plan->notes.push_back(note(each));
  plan->regenerated = std::move(regenerated);
  plan->models = std::move(opened.models);
  return plan;
}

std::unique_ptr<Plan> make_plan(const Scene& scene, std::shared_ptr<frf::FrfSystem> substructures,
                                std::shared_ptr<frf::FrfSystem> assembly) {
  if (scene.identify.automatic) {
    return plan_automatically(scene, *substructures, *assembly,
                              [&](const Scene& chosen) { return make_plan(chosen, substructures, assembly); });
  }
  auto plan = prepare_plan(scene, std::move(substructures), std::move(assembly));
  complete_plan(traits(plan->scene.identify.method).plan(*plan, plan_start), *plan);
  if (ignores_systematic_errors(scene)) plan->warnings.emplace_back(errors_taken_for_known);
  return plan;
}

std::unique_ptr<Plan> make_plan(const Scene& scene, std::vector<frf::FrfSet> substructures, std::vector<frf::FrfSet> assembly) {
  for (const auto* sets : {&substructures, &assembly}) {
    for (const frf::FrfSet& set : *sets) frf::validate(set);
  }
  const bool reciprocity = scene.data.reciprocity;
  return make_plan(scene, frf::memory_system("substructures", std::move(substructures), frf::Composition::uncoupled, reciprocity),
                   frf::memory_system("assembly", std::move(assembly), frf::Composition::merged, reciprocity));
}

std::unique_ptr<Plan> make_plan(const Scene& scene, Team& team) {
  std::unique_ptr<Plan> plan;
  const bool follows = scene.identify.automatic && team.rank() > 0;
  start_together(team, [&] {
    if (!follows) plan = make_plan(scene);
  });
  if (!scene.identify.automatic || team.size() == 1) return plan;
  std::vector<std::uint64_t> choice = {plan ? static_cast<std::uint64_t>(plan->scene.identify.method) : 0};
  team.share(choice);
  start_together(team, [&] {
    if (!follows) return;
    Scene chosen = scene;
    chosen.identify.method = static_cast<Method>(choice.front());
    chosen.identify.automatic = false;
    plan = make_plan(chosen);
    plan->chosen = "as the leader does";
  });
  return plan;
}

namespace {

void refuse_unshared(const Plan& plan, const Control& control) {
  if (control.shares.size() == 1) return;
  const std::string why = plan.method->not_shared(plan);
  if (why.empty()) return;
  fail(plan.scene, "mpirun", "several processes cannot share " + traits(plan.scene.identify.method).phrase + ": " + why,
       "run one process; it uses all cores");
}

}  // namespace

Solution solve(Plan& plan, const Control& asked) {
  Solution out;
  const Clock::time_point start = Clock::now();
  Control control = asked;
  if (asked.so_far) {
    control.so_far = [&asked, start](const Solution& best) {
      Solution timed = best;
      timed.runtime_s.total = seconds_since(start);
      asked.so_far(timed);
    };
  }
  refuse_unshared(plan, control);
  const WildLines wild = leave_out_absurd_lines(plan, control);
  out.dofs = plan.coordinates.joint;
  for (const ModalRegeneration& each : plan.regenerated) {
    if (!each.harm.empty()) out.warnings.push_back(note(each));
  }
  warn_of_shared_errors(plan, out);
  choose_weighting(plan, control, out.runtime_s);
  out.warnings.insert(out.warnings.end(), plan.warnings.begin(), plan.warnings.end());
  out.used = {plan.scene.identify.method, plan.equations,    plan.scene.identify.weighting,
              plan.scene.identify.delta,  name(plan.solver), plan.chosen};
  plan.method->solve(plan, control, out);
  find_loose_joints(plan, out);
  tell_wild_lines(wild, out);
  check_briefly(plan, control, out);
  out.models = used_models(plan);
  out.runtime_s.total = seconds_since(start);
  return out;
}

}  // namespace jointid::ident

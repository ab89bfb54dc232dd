#include "ident/likelihood/data/likelihood_plan.hpp"

#include <algorithm>
#include <span>

#include "base/error.hpp"
#include "base/text.hpp"
#include "ident/likelihood/data/many_lines.hpp"
#include "ident/likelihood/elimination/elimination_flops.hpp"
#include "ident/plan/joint_impedance.hpp"
#include "ident/scene/scene_failure.hpp"

namespace jointid::ident {
namespace {

bool has(const frf::FrfSystem& system, const frf::Dof& dof) {
  return frf::has(system.responses(), dof) || frf::has(system.references(), dof);
}

Dofs find_others(const Plan& plan) {
  Dofs others;
  for (const Dofs* dofs : {&plan.assembly->responses(), &plan.assembly->references()}) {
    for (const frf::Dof& dof : *dofs) {
      const bool known = frf::has(others, dof);
      const bool of_joint = frf::has(plan.coordinates.joint, dof);
      if (!known && !of_joint && has(*plan.substructures, dof)) others.push_back(dof);
    }
  }
  return others;
}

/// "gain of 1:+Y, gain of 2:+Y and 7 more"
std::string listed_names(const std::vector<NamedSystematic>& all) {
  constexpr std::size_t most = 4;
  const std::string text = comma_list(std::span(all).first(std::min(most, all.size())), &NamedSystematic::name);
  return all.size() > most ? text + " and " + std::to_string(all.size() - most) + " more" : text;
}

/// Where covariances of all FRFs of all lines would take too much memory, coupled FRFs are taken for independent.
void limit_error_sums(std::size_t lines, Observations& observations) {
  constexpr double most = 512e6;  // bytes
  const LineLayout& layout = observations.layout();
  const auto elements = static_cast<double>(layout.variables() + layout.drop_nn.size());
  if (observations.has_error_sums() && elements * elements * sizeof(Complex) * static_cast<double>(lines) > most) {
    observations.forget_error_sums();
  }
}

/// Why an equation cannot be used, or empty.
std::string lacks(const LikelihoodPlan& own, Equation equation, bool joint_on_assembly) {
  if (equation != Equation::jj && own.others.empty()) {
    return "no non-joint coordinate is in both the substructures and the assembly";
  }
  return equation == Equation::nn || joint_on_assembly ? "" : "the assembly has none of the joint DOFs";
}

/// Equations in the order nn nj jj jn; without a choice nn, nj and jj, which read all that jn does.
std::vector<Equation> choose_equations(const Plan& plan, const LikelihoodPlan& own, bool joint_on_assembly) {
  std::vector<Equation> out;
  const auto& named = plan.scene.identify.equations;
  for (const Equation equation : {Equation::nn, Equation::nj, Equation::jj, Equation::jn}) {
    const bool is_named = std::find(named.begin(), named.end(), equation) != named.end();
    if (named.empty() ? equation == Equation::jn : !is_named) continue;
    const std::string lack = lacks(own, equation, joint_on_assembly);
    if (lack.empty()) {
      out.push_back(equation);
    } else if (is_named) {
      fail(plan.scene, "[identify] equations", "equation " + name(equation) + " cannot be used: " + lack,
           "leave it out, measure what it lacks, or let `jointid check` look for a mistaken label");
    }
  }
  if (out.empty()) {
    fail(plan.scene, "[data]", "the data allow no equation: " + lacks(own, Equation::nn, joint_on_assembly), "measure it");
  }
  return out;
}

void choose_blocks(const EquationSet& use, LikelihoodPlan& own, bool joint_on_assembly) {
  LikelihoodBlocks& blocks = own.blocks;
  blocks.substructures = {.nn = use.nn, .jn = !own.others.empty(), .jj = use.nj || use.jj || use.jn || !joint_on_assembly};
  blocks.assembly = {.nn = use.nn, .jn = joint_on_assembly && !own.others.empty() && (use.nn || use.nj || use.jn),
                     .jj = use.jj || use.jn};
}

/// The scene's priors as of the columns they name.
std::vector<ScaledPrior> plan_priors(const Plan& plan) {
  std::vector<std::string> names;
  for (std::size_t column = 0; column < plan.columns->size(); ++column) {
    names.push_back(plan.columns->name(column, plan.restriction));
  }
  std::vector<ScaledPrior> priors;
  for (const Prior& prior : plan.scene.identify.priors) {
    const auto found = std::ranges::find(names, prior.unknown);
    if (found == names.end()) {
      const std::string near = nearest_word(prior.unknown, names);
      fail(plan.scene, "[identify] priors", "the joint has no unknown " + prior.unknown,
           near.empty() ? "`jointid plan` lists them" : "did you mean " + near + "?");
    }
    const auto column = static_cast<std::size_t>(found - names.begin());
    priors.push_back({column, prior.value / plan.unscale(column), plan.unscale(column) / prior.deviation});
  }
  return priors;
}

/// Priors of systematic errors, and what cannot go with them.
void plan_systematic(const Plan& plan, LikelihoodPlan& own, PlannedMethod& out) {
  const SystematicPlan* systematic = own.observations->systematic_plan();
  if (systematic == nullptr) return;
  const auto refuse = [&](const std::string& what, const std::string& remedy) {
    fail(plan.scene, "[data]", "gains, masses and errors of models as unknowns do not go with " + what, remedy);
  };
  if (out.solver != Solver::gauss_helmert) refuse("solver \"" + name(out.solver) + "\"", "leave solver out");
  if (plan.scene.identify.bootstrap > 0) refuse("a bootstrap", "leave bootstrap out");
  if (plan.admissible) refuse("definite, bounds and ties", "leave these out, or put the gains right in [data.files]");
  const std::size_t first = plan.columns->size();
  for (std::size_t u = 0; u < systematic->all().size(); ++u) own.priors.push_back({first + u, 0.0, 1.0});
  out.notes.push_back("Estimated with the joint: " + listed_names(systematic->all()) + ".");
}

/// Which assembly FRFs are predicted from its result.
void plan_prediction(const Dofs& joint, const LikelihoodPlan& own, PlannedMethod& out) {
  if (!own.blocks.substructures.jj) {
    out.left_out.push_back("the assembly FRF error: it needs H_bb, which the equations do not read");
    return;
  }
  const Blocks& blocks = own.blocks.assembly;
  out.predicted_responses = joined(only_if(blocks.nn || blocks.jn, own.others), only_if(blocks.jj, joint));
  out.predicted_references = joined(only_if(blocks.nn, own.others), only_if(blocks.jn || blocks.jj, joint));
}

/// Right-hand sides of a line's normal equations where unknowns that act alike share one, see RightSides.
std::size_t shared_right_sides(const Plan& plan, const LikelihoodPlan& own) {
  const double omega = angular(plan.lines.front().frequency_hz);
  const JointImpedance joint = joint_at(plan.restriction, *plan.columns, plan.omega0, omega);
  return joint.shapes().size() + own.observations->systematic().size() + 1;
}

/// How often the FRFs of all lines are linearised or optimised, an experience (docs/cost.md). With FRFs of the assembly at the
/// joint: of the start, and where weights change; between them factors stay. Of many large lines an eighth has those of the start.
/// With H_nn alone several starts are followed to the end, and more of them where few lines leave more of the joint open. Under
/// constraints the estimate goes on from its free minimum.
std::size_t expected_iterations(const Plan& plan, const LikelihoodPlan& own) {
  constexpr std::size_t usual = 8, of_many = 5, from_start = 100, guessed = 20'000, fewest = 150, most = 1'000, constrained = 4;
  const LineLayout& layout = own.observations->layout();
  std::size_t count = layout.is_large() && plan.lines.size() >= many_lines ? of_many : usual;
  if (layout.asm_jn.empty()) {
    count = own.start ? std::clamp(guessed / std::max<std::size_t>(1, plan.lines.size()), fewest, most) : from_start;
  }
  return plan.admissible ? count + constrained : count;
}

/// What is kept of a line: known FRFs of both systems with their variances, values and weights of the elements, two states with their own
/// steps (where it stands, and before the last step), and U⁻¹W with `columns`, shared ones where it is large.
double line_bytes(const LineLayout& layout, double columns) {
  const auto number = [](std::size_t i) { return static_cast<double>(i); };
  const double n = number(layout.joint), v = number(layout.variables());
  const double elements = v + number(layout.asm_jn.size() + layout.asm_jj.size() + layout.drop_nn.size());
  const double frfs = sizeof(Measured) * (elements + number(layout.drop_nn.size()));
  const double state = sizeof(Complex) * (2.0 * n * (number(layout.others) + n) + v);
  return frfs + 2.0 * sizeof(Complex) * elements + 2.0 * state + 2.0 * sizeof(double) * v * columns;
}

/// Flops of linearising a line and eliminating its FRFs: of large lines, as those of circular errors, by LineElimination where that
/// pays, else by ArrowElimination; of others by the rows of what was measured.
Iteration iteration_cost(const Plan& plan, const LikelihoodPlan& own) {
  const LineLayout& layout = own.observations->layout();
  const auto number = [](std::size_t i) { return static_cast<double>(i); };
  const std::size_t unknowns = plan.columns->size() + own.observations->systematic().size();
  const std::size_t shared = plan.lines.empty() ? unknowns + 1 : shared_right_sides(plan, own);
  const double v = number(layout.variables()), p = number(unknowns + 1), lines = number(plan.lines.size());
  Iteration out;
  out.expected = expected_iterations(plan, own);
  out.complex = layout.is_large();
  double each = 0.0, width = 0.0;
  if (elimination_pays(layout, shared)) {
    each = flops_by_elimination(layout, shared);
    out.matrix = std::max(layout.sub_jj.size(), layout.drop_nn.size());
    width = number(layout.sub_jj.size() + layout.drop_nn.size());
  } else if (out.complex) {
    const ArrowLayout arrow(layout);
    each = flops_by_arrow(layout, arrow, shared);
    out.matrix = static_cast<std::size_t>(arrow.core_size());
    width = v + number(shared);
  } else {
    each = 2.0 * flops_by_rows(layout, unknowns + 1);
    out.matrix = 2 * layout.variables();
    width = 2.0 * v + p;
  }
  out.flops = lines * each;
  const double back_columns = out.complex ? number(shared) : p;
  out.memory_bytes = static_cast<std::size_t>(lines * line_bytes(layout, back_columns) + 2.0 * (out.complex ? 16.0 : 8.0) * width * width);
  return out;
}

}  // namespace

PlannedMethod plan_observations(const Plan& plan, const StartPlanner& plan_start, std::unique_ptr<LikelihoodPlan> method) {
  PlannedMethod out = undecided(plan);
  LikelihoodPlan& own = *method;
  if (!plan.restriction.symmetric()) {
    fail(plan.scene, "[joint]", "method \"likelihood\" takes FRFs as reciprocal, and the joint is not symmetric",
         "use pattern = \"symmetric\" or a symmetric matrix");
  }
  own.others = find_others(plan);
  own.priors = plan_priors(plan);
  const Dofs& joint = plan.coordinates.joint;
  const bool joint_on_assembly = std::any_of(joint.begin(), joint.end(), [&](const auto& dof) { return has(*plan.assembly, dof); });
  out.equations = choose_equations(plan, own, joint_on_assembly);
  if (out.equations == std::vector{Equation::jj}) own.others.clear();
  const EquationSet use(out.equations);
  choose_blocks(use, own, joint_on_assembly);
  own.observations = std::make_unique<Observations>(plan.scene, joined(own.others, joint), own.others.size(), own.blocks,
                                                    *plan.substructures, *plan.assembly);
  limit_error_sums(plan.lines.size(), *own.observations);
  if (plan.scene.identify.start.empty()) {
    // Method One, else the likelihood by parts, else the direct solution.
    own.start = plan_start(
        plan, {{Method::one, plan.scene.identify.equations}, {Method::one, {}}, {Method::likelihood, {}}, {Method::direct, {}}});
    if (!own.observations->layout().reaches_joint()) {
      out.notes.push_back(
          "The assembly is not measured at the joint, and [identify] has no start: starts are guessed. One of yours, "
          "however rough, makes the right minimum surer.");
    }
  }
  out.coordinates.responses = out.coordinates.references = own.others;
  out.entries_per_line = own.observations->entries_per_line();
  const Solver asked = plan.scene.identify.solver;
  out.solver = asked == Solver::automatic ? Solver::gauss_helmert : asked;
  plan_systematic(plan, own, out);
  const std::size_t n = own.others.size(), j = joint.size();
  out.cost.lines = plan.lines.size();
  out.cost.columns = plan.columns->size();
  out.cost.equations_per_line = (use.nn ? n * (n + 1) / 2 : 0) + (own.blocks.assembly.jn ? n * j : 0) +
                                (own.blocks.assembly.jj ? j * (j + 1) / 2 : 0);
  out.cost.bytes_read = out.entries_per_line * sizeof(Complex) * plan.lines.size();
  out.cost.iteration = iteration_cost(plan, own);
  plan_prediction(joint, own, out);
  out.method = std::move(method);
  return out;
}

void LikelihoodPlan::read_first_line(const Plan& plan) {
  observations->read({plan.lines.front()}, [](std::size_t) {});
  if (start) start->method->read_first_line(*start);
}

std::string LikelihoodPlan::not_shared(const Plan& plan) const {
  if (plan.solver == Solver::ceres) return "solver \"ceres\" works on all lines at once";
  if (plan.scene.identify.bootstrap > 0) return "a bootstrap simulates all lines at once";
  if (const std::string why = start ? start->method->not_shared(*start) : ""; !why.empty()) return "to start, " + why;
  return observations->layout().asm_jn.empty() ? "with H_nn alone the start needs all lines at once" : "";
}

LikelihoodPlan* likelihood_plan(const Plan& plan) { return dynamic_cast<LikelihoodPlan*>(plan.method.get()); }

}  // namespace jointid::ident

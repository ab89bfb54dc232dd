#include "ident/prepare_plan.hpp"

#include <algorithm>

#include "base/complex.hpp"
#include "base/text.hpp"
#include "ident/admissible/admissible_set.hpp"
#include "ident/plan/couple_first.hpp"
#include "ident/plan/data_warnings.hpp"
#include "ident/plan/line_choice.hpp"
#include "ident/scene/scene_failure.hpp"
#include "minimise/least_squares.hpp"
#include "minimise/linear/sparse_qr.hpp"

namespace jointid::ident {
namespace {

/// Without variances there are no errors that a prior or a bootstrap could be weighed against.
void refuse_priors(const Scene& scene) {
  const std::string method = "method \"" + name(scene.identify.method) + "\"";
  if (!scene.identify.priors.empty()) {
    fail(scene, "[identify] priors", method + " has no use for priors", "use method \"likelihood\" or remove the key");
  }
  if (scene.identify.bootstrap > 0) {
    fail(scene, "[identify] bootstrap", method + " has no bootstrap", "use method \"likelihood\", or jointid study");
  }
}

/// "auto, qr or normal".
std::string listed(const std::vector<Solver>& own) {
  std::vector<std::string> words = names(own);
  words.insert(words.begin(), name(Solver::automatic));
  return one_of(words);
}

void require_solver(const Scene& scene, const std::vector<Solver>& own) {
  const IdentifySection& identify = scene.identify;
  if (identify.solver != Solver::automatic && std::ranges::find(own, identify.solver) == own.end()) {
    fail(scene, "[identify] solver", "method \"" + name(identify.method) + "\" has no solver \"" + name(identify.solver) + "\"",
         "use " + listed(own));
  }
  const auto require = [&](bool (*is_there)(), bool asked, const std::string& library, const std::string& package) {
    if (asked && !is_there()) fail(scene, "[identify] solver", "this build lacks " + library, "use auto, or build with " + package);
  };
  require(minimise::has_ceres, identify.solver == Solver::ceres, "Ceres", "libceres-dev");
  require(minimise::has_ipopt, identify.solver == Solver::ipopt, "Ipopt", "coinor-libipopt-dev");
  require(minimise::has_spqr, identify.solver == Solver::spqr, "SPQR", "libsuitesparse-dev");
  require(minimise::has_spqr, identify.solver == Solver::cholmod, "CHOLMOD", "libsuitesparse-dev");
}

void require_method(const Scene& scene) {
  const IdentifySection& identify = scene.identify;
  const MethodTraits& method = traits(identify.method);
  require_solver(scene, method.solvers);
  if (!method.uses_variances) refuse_priors(scene);
  if (method.iterates) return;
  for (const auto& [key, given] :
       {std::pair("[identify] start", !identify.start.empty()), std::pair("[identify] starts", identify.starts > 0)}) {
    if (given) fail(scene, key, "method \"" + method.name + "\" needs no start", "remove the key");
  }
}

/// Gives joints the node positions of the files where they have none.
void add_node_positions(const frf::FrfSystem& system, std::vector<restrictions::JointSpec>& joints) {
  for (restrictions::JointSpec& joint : joints) {
    for (std::size_t s = 0; s < system.source_count(); ++s) {
      for (const frf::Node& node : system.source(s).header().nodes) {
        joint.node_positions.try_emplace(node.id, node.position);
      }
    }
  }
}

/// What is put right in the files on reading, a note each.
void note_changes(const frf::FrfSystem& system, std::vector<std::string>& notes) {
  for (std::size_t s = 0; s < system.source_count(); ++s) {
    const frf::FrfHeader& header = system.source(s).header();
    std::string text;
    for (const std::string& change : header.changes) text += (text.empty() ? "" : "; ") + change;
    if (!text.empty()) notes.push_back(header.file + " is corrected on reading: " + text + ".");
  }
}

/// What the joints make of the unknowns; an error in them names the scene.
restrictions::Restriction build_restriction(const Scene& scene, const frf::FrfSystem& substructures,
                                            const frf::FrfSystem& assembly) {
  std::vector<restrictions::JointSpec> joints = scene.joints;
  add_node_positions(substructures, joints);
  add_node_positions(assembly, joints);
  try {
    return restrictions::build(joints);
  } catch (const InputError& error) {
    fail(scene, error.parts().place, error.parts().problem, error.parts().remedy);
  }
}

/// The equations, by parts where the assembly was not excited at its joints.
void choose_rows(const Scene& scene, Plan& plan) {
  try {
    plan.equations = choose_equations(scene, plan.coordinates, *plan.substructures, *plan.assembly);
  } catch (const InputError& lacking) {
    plan.equations = equations_by_parts(scene, plan.coordinates, *plan.substructures, *plan.assembly);
    if (plan.equations.empty()) throw;
    plan.why_by_parts = lacking.parts();
  }
}

}  // namespace

std::unique_ptr<Plan> prepare_plan(const Scene& scene, std::shared_ptr<frf::FrfSystem> substructures,
                                   std::shared_ptr<frf::FrfSystem> assembly) {
  require_method(scene);
  auto plan = std::make_unique<Plan>();
  plan->scene = scene;
  note_changes(*substructures, plan->notes);
  note_changes(*assembly, plan->notes);
  plan->substructures = couple_first(plan->scene, std::move(substructures), plan->notes);
  plan->assembly = std::move(assembly);
  plan->restriction = build_restriction(scene, *plan->substructures, *plan->assembly);
  if (plan->restriction.unknowns.empty()) {
    fail(scene, "[joint]", "every element of the joint is known: nothing to identify", "name an unknown");
  }
  plan->coordinates = find_coordinates(scene, plan->restriction, *plan->substructures, *plan->assembly);
  require_both_sides(*plan);
  if (!traits(scene.identify.method).uses_variances) {
    choose_rows(scene, *plan);
  }
  plan->lines = choose_lines(scene, *plan->substructures, *plan->assembly, plan->notes);
  plan->columns = std::make_unique<UnknownColumns>(plan->restriction, scene.joints);
  const double highest = angular(plan->lines.back().frequency_hz);
  plan->omega0 = highest == 0.0 ? 1.0 : highest;
  plan->admissible = plan_admissible(*plan);
  return plan;
}

namespace {

/// FRFs that are read for the estimate, its prediction, its judgement and where it starts from are read once when they are not too many.
void keep_frfs(Plan& plan) {
  constexpr std::size_t most = std::size_t{64} << 20;  // bytes
  const std::size_t with_noise = 2;
  if (with_noise * plan.entries_per_line * plan.lines.size() * sizeof(Complex) > most) return;
  plan.substructures->keep(most / 2);
  plan.assembly->keep(most / 2);
  plan.keeps_frfs = true;
}

/// What the method decided joins what was prepared.
void adopt(PlannedMethod decided, Plan& plan) {
  decided.left_out.insert(decided.left_out.begin(), plan.left_out.begin(), plan.left_out.end());
  decided.notes.insert(decided.notes.begin(), plan.notes.begin(), plan.notes.end());
  static_cast<PlannedMethod&>(plan) = std::move(decided);
}

}  // namespace

void complete_plan(PlannedMethod decided, Plan& plan) {
  adopt(std::move(decided), plan);
  keep_frfs(plan);
  for (const restrictions::Kind kind : restrictions::all_kinds) {
    if (!plan.restriction.has(kind)) plan.left_out.push_back(restrictions::key(kind) + ": no columns");
  }
  for (std::string& phrase : plan.method->left_out(plan)) plan.left_out.push_back(std::move(phrase));
  const std::size_t lines = plan.assembly->frequency_hz().size();
  if (plan.lines.size() < lines) {
    plan.left_out.push_back(std::to_string(lines - plan.lines.size()) + " of " + std::to_string(lines) + " lines: not read");
  }
  if (weighs_equations(plan.scene.identify.method) && plan.scene.identify.delta == 0.0)
    plan.left_out.push_back("the delta filter");
  DataDoubts doubts = doubts_of_data(plan);
  plan.notes.insert(plan.notes.end(), doubts.notes.begin(), doubts.notes.end());
  plan.warnings.insert(plan.warnings.end(), doubts.warnings.begin(), doubts.warnings.end());
}

}  // namespace jointid::ident

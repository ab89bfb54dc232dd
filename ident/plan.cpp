#include "ident/plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/complex.hpp"
#include "base/text.hpp"
#include "ident/admissible/admissible_set.hpp"
#include "ident/coordinates.hpp"
#include "ident/couple_first.hpp"
#include "ident/data_source.hpp"
#include "ident/data_warnings.hpp"
#include "ident/likelihood/likelihood_plan.hpp"
#include "ident/line_choice.hpp"
#include "ident/modal_regeneration.hpp"
#include "ident/newton/newton.hpp"
#include "ident/newton/newton_plan.hpp"
#include "ident/scene_failure.hpp"
#include "ident/supports.hpp"
#include "minimise/least_squares.hpp"

namespace jointid::ident {
namespace {

/// Methods but the likelihood have no errors that a prior or a bootstrap could be weighed against.
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
std::string listed(std::vector<std::string> words) {
  words.insert(words.begin(), "auto");
  return one_of(words);
}

void require_solver(const Scene& scene, const std::vector<std::string>& own) {
  const IdentifySection& identify = scene.identify;
  if (identify.solver != "auto" && std::ranges::find(own, identify.solver) == own.end()) {
    fail(scene, "[identify] solver", "method \"" + name(identify.method) + "\" has no solver \"" + identify.solver + "\"",
         "use " + listed(own));
  }
  const auto require = [&](bool is_there, bool asked, const std::string& library, const std::string& package) {
    if (asked && !is_there) fail(scene, "[identify] solver", "this build lacks " + library, "use auto, or build with " + package);
  };
  require(minimise::has_ceres(), identify.solver == "ceres", "Ceres", "libceres-dev");
  require(minimise::has_nlopt(), identify.solver.starts_with("nlopt"), "NLopt", "libnlopt-cxx-dev");
  require(minimise::has_ipopt(), identify.solver == "ipopt", "Ipopt", "coinor-libipopt-dev");
}

/// Solvers of a method by name, without auto.
std::vector<std::string> solvers_of(Method method) {
  if (method == Method::newton) return newton_solvers();
  if (method == Method::likelihood) return {"gauss-helmert", "iqml", "ceres"};
  return {"qr", "normal", "spqr"};
}

void require_method(const Scene& scene) {
  const IdentifySection& identify = scene.identify;
  require_solver(scene, solvers_of(identify.method));
  if (identify.method == Method::likelihood) return;
  refuse_priors(scene);
  if (identify.method == Method::newton) return;
  for (const auto& [key, given] :
       {std::pair("[identify] start", !identify.start.empty()), std::pair("[identify] starts", identify.starts > 0)}) {
    if (given) fail(scene, key, "method \"" + name(identify.method) + "\" needs no start", "remove the key");
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
restrictions::Restriction build_restriction(const Scene& scene, const frf::FrfSystem& substructures, const frf::FrfSystem& assembly) {
  std::vector<restrictions::JointSpec> joints = scene.joints;
  add_node_positions(substructures, joints);
  add_node_positions(assembly, joints);
  try {
    return restrictions::build(joints);
  } catch (const InputError& error) {
    fail(scene, error.parts().place, error.parts().problem, error.parts().remedy);
  }
}

void plan_assembly(Plan& plan) {
  AssemblySpec& spec = plan.assembly_spec;
  spec.restriction = &plan.restriction;
  spec.columns = plan.columns.get();
  spec.weighting = plan.scene.identify.weighting;
  spec.delta = plan.scene.identify.delta;
  const Dofs columns = plan.builder->columns();
  std::vector<std::size_t> joint_source, column_source;
  if (plan.substructures->source_count() > 1 && plan.scene.identify.method != Method::two) {
    for (const frf::Dof& dof : plan.coordinates.joint) joint_source.push_back(plan.substructures->source_of(dof));
    for (const frf::Dof& dof : columns) column_source.push_back(plan.substructures->source_of(dof));
  }
  choose_supports(plan.restriction, joint_source, column_source, columns.size(), spec);
  make_expanders(spec);
}

std::size_t a_rows(const Plan& plan) {
  const EquationSet use(plan.equations);
  if (plan.scene.identify.method == Method::two) return plan.coordinates.joint.size();
  return (use.nn || use.nj ? plan.coordinates.responses.size() : 0) +
         (use.jj || use.jn ? plan.coordinates.joint.size() : 0);
}

std::size_t count_equations(const Plan& plan) {
  const EquationSet use(plan.equations);
  const std::size_t joint = plan.coordinates.joint.size();
  const std::size_t n_rows = plan.coordinates.responses.size(), n_columns = plan.coordinates.references.size();
  return (use.nn ? n_rows * n_columns : 0) + (use.nj ? n_rows * joint : 0) + (use.jj ? joint * joint : 0) +
         (use.jn ? joint * n_columns : 0);
}

void count_cost(Plan& plan) {
  const AssemblySpec& spec = plan.assembly_spec;
  Cost& cost = plan.cost;
  cost.lines = plan.lines.size();
  cost.columns = plan.columns->size();
  cost.equations_per_line = count_equations(plan);
  cost.compressed_rows_per_line = compressed_rows(spec, a_rows(plan));
  cost.bytes_read = plan.entries_per_line * sizeof(Complex) * cost.lines;
  const auto lines = static_cast<double>(cost.lines), unknowns = static_cast<double>(plan.restriction.unknowns.size());
  const auto n = static_cast<double>(plan.coordinates.joint.size());
  const auto m = static_cast<double>(a_rows(plan)), l = static_cast<double>(plan.builder->columns().size());
  cost.assemble_flops =
      lines * (16.0 * n * n * (m + l) + 8.0 * m * l * n + reduction_flops(spec, a_rows(plan)));
  cost.stacked_flops =
      lines * static_cast<double>(cost.equations_per_line) * (8.0 * n * n + 4.0 * unknowns * unknowns);
}

/// SPQR pays when the stacked triangles are mostly empty and large.
void choose_solver(Plan& plan) {
  plan.solver = plan.scene.identify.solver;
  if (plan.solver != "auto") return;
  std::size_t touched = 0;
  for (const Support& support : plan.assembly_spec.supports) touched = std::max(touched, support.unknowns.size());
  const std::size_t columns = plan.columns->size();
  plan.solver = columns >= 200 && 4 * touched <= columns ? "spqr" : "qr";
}

void plan_linear(Plan& plan) {
  plan.builder = make_builder(plan);
  plan.entries_per_line = plan.builder->entries_per_line();
  plan_assembly(plan);
  choose_solver(plan);
  count_cost(plan);
}

/// The assembly FRFs that the equations use are predicted; that takes H_bb and all substructure FRFs to and from the joint.
void plan_prediction(Plan& plan) {
  const EquationSet use(plan.equations);
  const Coordinates& at = plan.coordinates;
  const Method method = plan.scene.identify.method;
  if (method == Method::likelihood) {
    plan_likelihood_prediction(plan);
    return;
  }
  if (method == Method::one && !use.nj && !use.jj) {
    plan.left_out.push_back("the assembly FRF error: it needs H_bb, which the equations do not read");
    return;
  }
  if (method == Method::direct || method == Method::newton) {
    plan.predicted_responses = at.responses;
    plan.predicted_references = at.references;
    return;
  }
  const bool two = method == Method::two;
  const bool joint_rows = two || use.jj || use.jn, joint_columns = !two || use.jj;
  plan.predicted_responses = joined(two || use.nn || use.nj ? at.responses : Dofs(), joint_rows ? at.joint : Dofs());
  plan.predicted_references = joined(use.nn || use.jn ? at.references : Dofs(), joint_columns ? at.joint : Dofs());
}

void tell_left_out(Plan& plan) {
  for (const restrictions::Kind kind : restrictions::all_kinds) {
    if (!plan.restriction.has(kind)) plan.left_out.push_back(restrictions::key(kind) + ": no columns");
  }
  if (plan.scene.identify.method == Method::one) {
    const EquationSet use(plan.equations);
    const std::pair<bool, const char*> blocks[] = {{use.nn, "H_aa and H_nn"},      {use.nn || use.nj, "H_nj"},
                                                   {use.nn || use.jn, "H_ba"},     {use.nj, "H_ab"},
                                                   {use.nj || use.jj, "H_bb"},     {use.jj || use.jn, "H_jj"},
                                                   {use.jn, "H_jn"}};
    for (const auto& [used, block] : blocks) {
      if (!used) plan.left_out.push_back(std::string(block) + ": not read");
    }
  }
  const std::size_t lines = plan.assembly->frequency_hz().size();
  if (plan.lines.size() < lines) {
    plan.left_out.push_back(std::to_string(lines - plan.lines.size()) + " of " + std::to_string(lines) +
                            " lines: not read");
  }
  if (plan.builder && plan.scene.identify.delta == 0.0) plan.left_out.push_back("the delta filter");
}

}  // namespace

std::unique_ptr<EquationBuilder> make_builder(Plan& plan) {
  switch (plan.scene.identify.method) {
    case Method::two:
      return make_method_two(plan.coordinates, EquationSet(plan.equations), *plan.substructures, *plan.assembly);
    case Method::direct:
      return make_direct(plan.coordinates, *plan.substructures, *plan.assembly);
    default:
      return make_method_one(plan.coordinates, EquationSet(plan.equations), *plan.substructures, *plan.assembly);
  }
}

std::unique_ptr<Plan> make_plan(const Scene& scene) {
  std::vector<ModalRegeneration> regenerated;
  const auto open_system = [&](const char* name, const std::vector<DataFile>& files, frf::Composition composition, bool by_modes) {
    auto sources = open_all(files);
    if (by_modes) sources = regenerate_sources(std::move(sources), composition == frf::Composition::merged, scene, regenerated);
    return std::make_unique<frf::FrfSystem>(name, std::move(sources), composition, scene.data.reciprocity);
  };
  const Regeneration chosen = scene.data.regenerate;
  auto substructures = open_system("substructures", scene.data.substructures, frf::Composition::uncoupled, chosen.substructures);
  auto assembly = open_system("assembly", scene.data.assembly, frf::Composition::merged, chosen.assembly);
  auto plan = make_plan(scene, std::move(substructures), std::move(assembly));
  for (const ModalRegeneration& each : regenerated) plan->notes.push_back(note(each));
  plan->regenerated = std::move(regenerated);
  return plan;
}

std::unique_ptr<Plan> make_plan(const Scene& scene, std::shared_ptr<frf::FrfSystem> substructures,
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
  const Method method = scene.identify.method;
  if (method != Method::likelihood) plan->equations = choose_equations(scene, plan->coordinates, *plan->substructures, *plan->assembly);
  plan->lines = choose_lines(scene, *plan->substructures, *plan->assembly, plan->notes);
  plan->columns = std::make_unique<UnknownColumns>(plan->restriction, scene.joints);
  const double highest = angular(plan->lines.back().frequency_hz);
  plan->assembly_spec.omega0 = highest == 0.0 ? 1.0 : highest;
  plan->admissible = plan_admissible(*plan);
  if (plan->admissible && method == Method::newton) {
    fail(scene, "[identify] method", "method \"newton\" has no constraints",
         "use method \"likelihood\", or leave definite, bounds and ties out");
  }
  if (method == Method::likelihood) {
    plan_likelihood(*plan);
  } else if (method == Method::newton) {
    plan_newton(*plan);
  } else {
    plan_linear(*plan);
  }
  plan_prediction(*plan);
  tell_left_out(*plan);
  warn_of_data(*plan);
  return plan;
}

double Plan::unscale(std::size_t column) const {
  return ident::unscale(restriction.unknowns[columns->unknown_of(column)].kind, assembly_spec.omega0);
}

void read_first_line(Plan& plan) {
  if (plan.builder) {
    plan.builder->read(std::array{plan.lines.front().substructures}, std::array{plan.lines.front().assembly});
    return;
  }
  if (plan.newton) {
    read_responses(plan, 1);
    if (plan.newton->start) read_first_line(*plan.newton->start);
    return;
  }
  plan.likelihood->observations->read({plan.lines.front()}, [](std::size_t) {});
  if (plan.likelihood->start) read_first_line(*plan.likelihood->start);
}

}  // namespace jointid::ident

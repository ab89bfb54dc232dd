#include "ident/equations/linear_plan.hpp"

#include <algorithm>
#include <array>

#include "base/complex.hpp"
#include "ident/equations/supports.hpp"
#include "minimise/linear/sparse_qr.hpp"

namespace jointid::ident {
namespace {

void plan_assembly(const Plan& plan, LinearPlan& own) {
  AssemblySpec& spec = own.spec;
  spec.omega0 = plan.omega0;
  spec.restriction = &plan.restriction;
  spec.columns = plan.columns.get();
  spec.weighting = plan.scene.identify.weighting;
  spec.delta = plan.scene.identify.delta;
  const Dofs columns = own.builder->columns();
  if (!own.parts.empty()) {
    own.part_specs = part_specs(own.parts, spec, columns.size());
    spec.column_support.assign(columns.size(), 0);
    for (const PartOfRows& part : own.parts) spec.supports.push_back(part.support);
    return;
  }
  std::vector<std::size_t> joint_source, column_source;
  if (plan.substructures->source_count() > 1 && own.keeps_parts_apart()) {
    for (const frf::Dof& dof : plan.coordinates.joint) joint_source.push_back(plan.substructures->source_of(dof));
    for (const frf::Dof& dof : columns) column_source.push_back(plan.substructures->source_of(dof));
  }
  choose_supports(plan.restriction, joint_source, column_source, columns.size(), spec);
  make_expanders(spec);
}

std::size_t count_equations(const Plan& plan, const LinearPlan& own) {
  if (!own.parts.empty()) {
    std::size_t rows = 0;
    for (const PartOfRows& part : own.parts) rows += part.n_rows.size() + part.j_rows.size();
    return rows * own.builder->columns().size();
  }
  const EquationSet use(plan.equations);
  const std::size_t joint = plan.coordinates.joint.size();
  const std::size_t n_rows = plan.coordinates.responses.size(), n_columns = plan.coordinates.references.size();
  return (use.nn ? n_rows * n_columns : 0) + (use.nj ? n_rows * joint : 0) + (use.jj ? joint * joint : 0) +
         (use.jn ? joint * n_columns : 0);
}

/// Rows by parts: each of a few coordinates.
void add_parts(const LinearPlan& own, double lines, double columns, Cost& cost) {
  for (const PartOfRows& part : own.parts) {
    const std::size_t m = part.n_rows.size() + part.j_rows.size(), na = part.support.a_dofs.size(), nb = part.support.b_dofs.size();
    const std::size_t l = static_cast<std::size_t>(columns), rows = 2 * std::min(m, na) * std::min(l, nb);
    const auto unknowns = static_cast<double>(part.support.unknowns.size() + 1), equations = static_cast<double>(m) * columns;
    cost.compressed_rows_per_line += rows;
    cost.assemble_flops += lines * (16.0 * (static_cast<double>(m * na * na) + columns * static_cast<double>(nb * nb)) +
                                    8.0 * equations * static_cast<double>(na) + 2.0 * static_cast<double>(rows) * unknowns * unknowns);
    cost.stacked_flops += lines * equations * (8.0 * static_cast<double>(na * nb) + 4.0 * unknowns * unknowns);
  }
}

Cost cost_of(const Plan& plan, const LinearPlan& own) {
  const AssemblySpec& spec = own.spec;
  Cost cost;
  cost.lines = plan.lines.size();
  cost.columns = plan.columns->size();
  cost.equations_per_line = count_equations(plan, own);
  cost.compressed_rows_per_line = own.parts.empty() ? compressed_rows(spec, own.rows_of_a(plan)) : 0;
  cost.bytes_read = own.builder->entries_per_line() * sizeof(Complex) * cost.lines;
  const auto lines = static_cast<double>(cost.lines), unknowns = static_cast<double>(plan.restriction.unknowns.size());
  const auto n = static_cast<double>(plan.coordinates.joint.size());
  const auto m = static_cast<double>(own.rows_of_a(plan)), l = static_cast<double>(own.builder->columns().size());
  if (!own.parts.empty()) {
    add_parts(own, lines, l, cost);
    return cost;
  }
  cost.assemble_flops = lines * (16.0 * n * n * (m + l) + 8.0 * m * l * n + reduction_flops(spec, own.rows_of_a(plan)));
  cost.stacked_flops = lines * static_cast<double>(cost.equations_per_line) * (8.0 * n * n + 4.0 * unknowns * unknowns);
  return cost;
}

/// Sparse solvers pay where there are many unknowns and no part carries more than half of them (docs/many-joints.md). Ties and bounds
/// are dense.
Solver choose_solver(const Plan& plan, const LinearPlan& own) {
  constexpr std::size_t least = 150;
  if (plan.scene.identify.solver != Solver::automatic) return plan.scene.identify.solver;
  std::size_t touched = 0;
  for (const Support& support : own.spec.supports) touched = std::max(touched, support.unknowns.size());
  const std::size_t columns = plan.columns->size();
  if (columns < least || 2 * touched > columns) return Solver::qr;
  return minimise::has_spqr() ? Solver::spqr : Solver::ldlt;
}

}  // namespace

std::size_t LinearPlan::rows_of_a(const Plan& plan) const {
  const EquationSet use(plan.equations);
  return (use.nn || use.nj ? plan.coordinates.responses.size() : 0) + (use.jj || use.jn ? plan.coordinates.joint.size() : 0);
}

void LinearPlan::read_first_line(const Plan& plan) {
  builder->read(std::array{plan.lines.front().substructures}, std::array{plan.lines.front().assembly});
}

LinearPlan* linear_plan(const Plan& plan) { return dynamic_cast<LinearPlan*>(plan.method.get()); }

PlannedMethod plan_linear(const Plan& plan, LinearPlan& own) {
  PlannedMethod out = undecided(plan);
  own.builder = own.make_builder(plan);
  out.entries_per_line = own.builder->entries_per_line();
  plan_assembly(plan, own);
  out.solver = choose_solver(plan, own);
  out.cost = cost_of(plan, own);
  return out;
}

}  // namespace jointid::ident

#include "ident/newton/newton_plan.hpp"

#include <algorithm>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "base/stop_scope.hpp"
#include "minimise/linear/eigen_view.hpp"

namespace jointid::ident {
namespace {

/// Flops of the residuals and their derivatives of a line, and of its rows in the triangle.
Iteration iteration_cost(const Plan& plan, std::size_t entries_per_line) {
  constexpr std::size_t usual = 20;
  const auto number = [](std::size_t i) { return static_cast<double>(i); };
  const double n = number(plan.coordinates.joint.size()), p = number(plan.columns->size());
  const double m = number(plan.coordinates.responses.size()), l = number(plan.coordinates.references.size());
  const double line = 8.0 * (4.0 / 3.0 * n * n * n + n * n * (m + l) + m * l * n) + m * l * p * (8.0 + 4.0 * p);
  const std::size_t lines = plan.lines.size();
  return {.expected = usual,
          .flops = number(lines) * line,
          .matrix = std::max<std::size_t>(8, plan.coordinates.joint.size()),
          .complex = false,
          .memory_bytes = lines * entries_per_line * sizeof(Complex)};
}

}  // namespace

PlannedMethod plan_responses(const Plan& plan, const StartPlanner& plan_start, std::unique_ptr<NewtonPlan> own) {
  PlannedMethod out = undecided(plan);
  const Coordinates& at = plan.coordinates;
  const Dofs columns = joined(at.references, at.joint);
  own->substructures =
      std::make_unique<Rectangle>(*plan.substructures, std::vector<Band>{{joined(at.responses, at.joint), columns}}, columns);
  own->assembly = std::make_unique<Rectangle>(*plan.assembly, std::vector<Band>{{at.responses, at.references}}, at.references);
  out.entries_per_line = own->substructures->entries_per_line() + own->assembly->entries_per_line();
  const Solver asked = plan.scene.identify.solver;
  out.solver = asked == Solver::automatic ? Solver::levenberg_marquardt : asked;
  if (plan.scene.identify.start.empty()) own->start = plan_start(plan, {{Method::direct, {}}});
  out.cost.lines = plan.lines.size();
  out.cost.columns = plan.columns->size();
  out.cost.equations_per_line = at.responses.size() * at.references.size();
  out.cost.bytes_read = out.entries_per_line * sizeof(Complex) * plan.lines.size();
  out.cost.iteration = iteration_cost(plan, out.entries_per_line);
  out.predicted_responses = at.responses;
  out.predicted_references = at.references;
  out.method = std::move(own);
  return out;
}

void NewtonPlan::read_first_line(const Plan& plan) {
  read_responses(plan, 1);
  if (start) start->method->read_first_line(*start);
}

std::vector<ResponseLine> NewtonPlan::read_responses(const Plan& plan, std::size_t count) {
  std::vector<std::size_t> substructure_lines, assembly_lines;
  for (std::size_t i = 0; i < count; ++i) {
    substructure_lines.push_back(plan.lines[i].substructures);
    assembly_lines.push_back(plan.lines[i].assembly);
  }
  substructures->read(substructure_lines);
  assembly->read(assembly_lines);
  const std::size_t rows = plan.coordinates.responses.size(), columns = plan.coordinates.references.size();
  const std::size_t joint = plan.coordinates.joint.size();
  std::vector<ResponseLine> lines;
  for (std::size_t i = 0; i < count; ++i) {
    stop_point();
    const minimise::View h = substructures->line(i);
    ReachableFrfs frfs = {map(h.block(0, 0, rows, columns)), map(h.block(0, columns, rows, joint)), map(h.block(rows, 0, joint, columns)),
                          map(h.block(rows, columns, joint, joint)), map(assembly->line(i))};
    lines.emplace_back(std::move(frfs), joint_at(plan.restriction, *plan.columns, plan.omega0, angular(plan.lines[i].frequency_hz)));
  }
  return lines;
}

}  // namespace jointid::ident

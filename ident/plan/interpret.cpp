#include "ident/plan/interpret.hpp"

#include <span>

#include "ident/result/quality.hpp"
#include "restrictions/impedance_factor.hpp"

namespace jointid::ident {
namespace {

std::string joined_names(const Plan& plan, const std::vector<std::size_t>& columns) {
  std::string text;
  for (const std::size_t column : columns) {
    if (!text.empty()) text += ", ";
    text += plan.columns->name(column, plan.restriction);
  }
  return text;
}

void judge_status(const Plan& plan, const minimise::LinearSolution& linear, Solution& out) {
  if (linear.rank == plan.columns->size()) return;
  out.status = Status::rank_deficient;
  if (plan.solver == Solver::normal) {
    out.message = "The normal equations are not positive definite: use solver \"qr\".";
    for (Estimate& estimate : out.unknowns) estimate.determined = false;
    return;
  }
  out.message = "The data do not fix " + std::to_string(linear.free_directions.size()) + " of " +
                std::to_string(plan.columns->size()) + " combinations of unknowns:";
  constexpr std::size_t most = 12, named = 6;
  const std::size_t count = linear.free_directions.size(), shown = count > most ? named : count;
  for (const minimise::FreeDirection& direction : std::span(linear.free_directions).first(shown)) {
    const bool alone = direction.columns.size() == 1;
    out.message += " " + joined_names(plan, direction.columns) + (alone ? " is free;" : " move together;");
  }
  if (shown < count) out.message += " and " + std::to_string(count - shown) + " more;";
  for (const std::size_t column : linear.undetermined) out.unknowns[column].determined = false;
  out.message.back() = '.';
  out.message += " Measure more coordinates or lines, or tie unknowns in the joint's matrices.";
}

/// The joint matrices between two neighbouring band limits.
Matrices matrices_for(const Plan& plan, const std::vector<std::size_t>& columns, const Solution& solution) {
  std::vector<double> y;
  for (const std::size_t column : columns) y.push_back(solution.unknowns[column].value);
  const std::size_t n = plan.restriction.dofs.size();
  Matrices matrices;
  for (const restrictions::MatrixTerms& terms : plan.restriction.matrices) {
    const std::vector<double> flat = plan.restriction.matrix(terms.kind, y);
    Matrix& matrix = matrices[terms.kind];
    for (std::size_t i = 0; i < n; ++i) {
      const auto row = flat.begin() + static_cast<std::ptrdiff_t>(i * n);
      matrix.emplace_back(row, row + static_cast<std::ptrdiff_t>(n));
    }
  }
  return matrices;
}

void fill_bands(const Plan& plan, Solution& out) {
  const std::vector<double>& limits = plan.columns->limits_hz();
  if (limits.empty()) {
    out.bands.push_back({std::nullopt, matrices_for(plan, plan.columns->at(0.0), out)});
    return;
  }
  for (std::size_t k = 0; k + 1 < limits.size(); ++k) {
    const std::vector<std::size_t> columns = plan.columns->at(0.5 * (limits[k] + limits[k + 1]));
    if (!columns.empty()) out.bands.push_back({Range{limits[k], limits[k + 1]}, matrices_for(plan, columns, out)});
  }
}

void fill_quality(const Plan& plan, Solution& out) {
  for (const auto& [kind, truth] : plan.scene.truth) {
    Matrix identified, exact;
    for (const BandMatrices& band : out.bands) {
      const auto found = band.matrices.find(kind);
      if (found == band.matrices.end()) continue;
      identified.insert(identified.end(), found->second.begin(), found->second.end());
      exact.insert(exact.end(), truth.begin(), truth.end());
    }
    if (identified.empty()) continue;
    if (const auto quality = judge(identified, exact)) out.quality[kind] = *quality;
  }
}

void fill_unknowns(const Plan& plan, const minimise::LinearSolution& linear, Solution& out) {
  for (std::size_t column = 0; column < plan.columns->size(); ++column) {
    const restrictions::Unknown& unknown = plan.restriction.unknowns[plan.columns->unknown_of(column)];
    Estimate estimate;
    estimate.name = plan.columns->name(column, plan.restriction);
    estimate.unit = unknown.unit;
    estimate.value = linear.y[column] * unscale(unknown.kind, plan.omega0);
    out.unknowns.push_back(std::move(estimate));
  }
}

}  // namespace

void interpret(const Plan& plan, const minimise::LinearSolution& linear, Solution& out) {
  out.fit.rank = linear.rank;
  out.fit.condition = linear.condition;
  fill_unknowns(plan, linear, out);
  judge_status(plan, linear, out);
  fill_bands(plan, out);
  fill_quality(plan, out);
}

}  // namespace jointid::ident

#include "ident/solve.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/stopwatch.hpp"
#include "ident/admissible/admissible_linear.hpp"
#include "ident/admissible/outcome.hpp"
#include "ident/check/check.hpp"
#include "ident/judgement/judge.hpp"
#include "ident/likelihood/likelihood.hpp"
#include "ident/newton/newton.hpp"
#include "ident/prediction.hpp"
#include "ident/quality.hpp"
#include "ident/rounding_judgement.hpp"

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

void judge_status(const Plan& plan, const LinearSolution& linear, Solution& out) {
  if (linear.rank == plan.columns->size()) return;
  out.status = Status::rank_deficient;
  if (plan.solver == "normal") {
    out.message = "The normal equations are not positive definite: use solver \"qr\".";
    for (Estimate& estimate : out.unknowns) estimate.determined = false;
    return;
  }
  out.message = "The data do not fix " + std::to_string(linear.free_directions.size()) + " of " +
                std::to_string(plan.columns->size()) + " combinations of unknowns:";
  for (const FreeDirection& direction : linear.free_directions) {
    const bool alone = direction.columns.size() == 1;
    out.message += " " + joined_names(plan, direction.columns) + (alone ? " is free;" : " move together;");
  }
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

void fill_unknowns(const Plan& plan, const LinearSolution& linear, Solution& out) {
  for (std::size_t column = 0; column < plan.columns->size(); ++column) {
    const restrictions::Unknown& unknown = plan.restriction.unknowns[plan.columns->unknown_of(column)];
    Estimate estimate;
    estimate.name = plan.columns->name(column, plan.restriction);
    estimate.unit = unknown.unit;
    estimate.value = linear.y[column] * unscale(unknown.kind, plan.assembly_spec.omega0);
    out.unknowns.push_back(std::move(estimate));
  }
}

}  // namespace

void interpret(const Plan& plan, const LinearSolution& linear, Solution& out) {
  out.fit.rank = linear.rank;
  out.fit.condition = linear.condition;
  fill_unknowns(plan, linear, out);
  judge_status(plan, linear, out);
  fill_bands(plan, out);
  fill_quality(plan, out);
}

LinearSolution solve(const Plan& plan, Accumulator& accumulator, Condition condition) {
  if (plan.solver == "normal") return solve_normal(accumulator, condition);
  return plan.solver == "spqr" ? solve_sparse(accumulator, condition) : solve_dense(accumulator, condition);
}

namespace {

std::string without_equations(const Plan& plan) {
  const bool filtered = plan.scene.identify.delta > 0.0;
  return std::string("No equation is left: the FRFs are missing or zero, or their matrices singular, on every line") +
         (filtered ? ", or delta dropped them. Lower delta" : ". Choose other lines") +
         ", or look with `jointid info` at what the files hold.";
}

std::optional<double> assembly_error(Plan& plan, const Solution& solution, const Control& control) {
  if (plan.predicted_responses.empty()) return std::nullopt;
  const DecibelError error = predict(plan, solution.bands, control);
  if (error.entries == 0) return std::nullopt;
  return std::sqrt(error.sum_of_squares / static_cast<double>(error.entries));
}

/// What the FRFs' variances do not say of their errors.
void warn_of_shared_errors(const Plan& plan, Solution& out) {
  if (!plan.likelihood) return;
  std::string which;
  if (!plan.scene.couple_first.pairs.empty()) which = "the FRFs of the coupled parts";
  if (!plan.regenerated.empty()) which += (which.empty() ? "" : " and ") + std::string("regenerated FRFs");
  if (which.empty()) return;
  out.warnings.push_back("The likelihood takes the errors of FRFs for independent; those of " + which +
                         " are not, so that standard errors and intervals are too small.");
}

void identify(Plan& plan, Assembled& system, const Control& control, Solution& out) {
  LinearSolution linear;
  bool settled = true;
  {
    const Stopwatch watch(out.runtime_s.solve);
    stop_if(control.interrupted);
    if (control.progress) control.progress("solving", 0, 0);
    linear = solve(plan, system.accumulator, control.detail == Detail::full ? Condition::compute : Condition::skip);
    if (plan.admissible && linear.rank > 0) out.admissibility = constrain(plan, system.accumulator, system.equations.rows, linear, settled);
  }
  interpret(plan, linear, out);
  if (out.admissibility) {
    tell_outcome(plan, out);
  } else if (control.detail == Detail::full) {
    judge_rounding(plan, linear, system.rounding, out);
  }
  if (!settled) {
    out.status = Status::not_converged;
    out.message += "The constrained least-squares problem did not settle.";
  }
  if (control.so_far) control.so_far(out);
  if (control.detail == Detail::full) out.fit.asm_frf_error = assembly_error(plan, out, control);
  if (control.detail == Detail::full && control.judgement == Judgement::data) judge_linear(plan, linear, control, out);
}

/// What the short check of the data finds, in status and message.
void check_briefly(Plan& plan, const Control& control, Solution& out) {
  if (control.detail != Detail::full || control.judgement != Judgement::data) return;
  out.check = quick_check(plan, control);
  tell_check(*out.check, out);
}

}  // namespace

Solution solve(Plan& plan, const Control& control) {
  Solution out;
  const Clock::time_point start = Clock::now();
  out.dofs = plan.coordinates.joint;
  for (const ModalRegeneration& each : plan.regenerated) {
    if (!each.harm.empty()) out.warnings.push_back(note(each));
  }
  warn_of_shared_errors(plan, out);
  out.warnings.insert(out.warnings.end(), plan.warnings.begin(), plan.warnings.end());
  out.used = {plan.scene.identify.method, plan.equations, plan.scene.identify.weighting, plan.scene.identify.delta,
              plan.solver, 0};
  if (plan.likelihood || plan.newton) {
    plan.likelihood ? solve_likelihood(plan, control, out) : solve_newton(plan, control, out);
    if (control.so_far) control.so_far(out);
    if (control.detail == Detail::full) out.fit.asm_frf_error = assembly_error(plan, out, control);
    check_briefly(plan, control, out);
    out.runtime_s.total = std::chrono::duration<double>(Clock::now() - start).count();
    return out;
  }
  Assembled system = assemble(plan, out.runtime_s, control);
  out.fit.equations_used = system.equations.used;
  out.fit.equations_dropped = system.equations.dropped;
  out.fit.lines = system.lines;
  out.used.accumulator_bytes = system.accumulator.bytes();
  if (system.equations.used > 0) {
    identify(plan, system, control, out);
  } else {
    out.status = Status::no_equations;
    out.message = without_equations(plan);
  }
  check_briefly(plan, control, out);
  out.runtime_s.total = std::chrono::duration<double>(Clock::now() - start).count();
  return out;
}

}  // namespace jointid::ident

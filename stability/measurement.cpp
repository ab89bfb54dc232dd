#include "stability/measurement.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include "base/statistics.hpp"
#include "ident/equations/assemble.hpp"
#include "ident/identify.hpp"
#include "ident/plan/interpret.hpp"
#include "stability/exact_fit.hpp"
#include "stability/svd_solution.hpp"

namespace jointid::stability {
namespace {

ident::Control one_thread() {
  ident::Control control;
  control.threads = 1;
  control.judgement = ident::Judgement::none;
  return control;
}

bool is_svd(Way way) { return way == Way(OwnWay::svd); }

ident::Solution solved(const ExtremeProblem& problem, Way way) {
  if (!is_svd(way)) return ident::solve(*problem.plan(std::get<ident::Solver>(way)), one_thread());
  using Clock = std::chrono::steady_clock;
  const auto plan = problem.plan(ident::Solver::qr);
  ident::Solution out;
  ident::Assembled system = ident::assemble(*plan, out.runtime_s, one_thread());
  const auto start = Clock::now();
  const minimise::LinearSolution linear = solve_svd(system.accumulator);
  out.runtime_s.solve = std::chrono::duration<double>(Clock::now() - start).count();
  out.fit.lines = system.lines;
  out.used.accumulator_bytes = system.accumulator.bytes();
  ident::interpret(*plan, linear, out);
  return out;
}

/// ‖W(y − y₅₀)‖/‖Wy₅₀‖.
double kept_error(const ident::Solution& solution, const ExactEstimate& exact) {
  double difference = 0.0, size = 0.0;
  for (std::size_t j = 0; j < exact.values.size(); ++j) {
    difference = std::hypot(difference, exact.column_norms[j] * (solution.unknowns[j].value - exact.values[j]));
    size = std::hypot(size, exact.column_norms[j] * exact.values[j]);
  }
  return difference / size;
}

/// Of each unknown, the largest of those that it is compared with.
std::vector<double> sizes_of(const ExtremeProblem& problem) {
  std::map<std::size_t, double> largest;
  const auto group = [&](std::size_t j) { return problem.group.empty() ? 0 : problem.group[j]; };
  for (std::size_t j = 0; j < problem.truth.size(); ++j) {
    double& to = largest[group(j)];
    to = std::max(to, std::abs(problem.truth[j]));
  }
  std::vector<double> out;
  for (std::size_t j = 0; j < problem.truth.size(); ++j) out.push_back(largest[group(j)]);
  return out;
}

/// The worst error of an unknown over its size.
double worst_error(const ident::Solution& solution, const ExtremeProblem& problem) {
  const std::vector<double> sizes = sizes_of(problem);
  double worst = 0.0;
  for (std::size_t j = 0; j < problem.truth.size(); ++j) {
    const double error = std::abs(solution.unknowns[j].value - problem.truth[j]);
    worst = std::isnan(error) ? HUGE_VAL : std::max(worst, error / sizes[j]);
  }
  return worst;
}

/// What the solution states of the error of an unknown.
std::optional<double> stated(const ident::Estimate& unknown) { return unknown.rounding ? unknown.rounding : unknown.std_error; }

Honesty judged(const ident::Solution& solution, const ExtremeProblem& problem) {
  const bool told = solution.status != ident::Status::ok || !solution.warnings.empty();
  const double worst = worst_error(solution, problem);
  bool beyond = false, has_bound = false;
  for (std::size_t j = 0; j < problem.truth.size(); ++j) {
    const double error = std::abs(solution.unknowns[j].value - problem.truth[j]);
    const std::optional<double> bound = stated(solution.unknowns[j]);
    has_bound = has_bound || bound;
    beyond = beyond || (bound && !(error <= 10.0 * *bound));
  }
  if (told) return worst < 1e-6 ? Honesty::false_alarm : Honesty::told;
  if (!has_bound) return Honesty::not_judged;
  if (beyond) return Honesty::silent_wrong;
  return worst < 1e-6 ? Honesty::right : Honesty::told;
}

}  // namespace

std::string name(Honesty verdict) {
  switch (verdict) {
    case Honesty::told:
      return "told";
    case Honesty::right:
      return "right";
    case Honesty::silent_wrong:
      return "silent wrong";
    case Honesty::false_alarm:
      return "false alarm";
    case Honesty::not_judged:
      break;
  }
  return "–";
}

double digits(double relative_error) {
  if (std::isnan(relative_error)) return 0.0;
  return std::clamp(-std::log10(relative_error), 0.0, 16.0) + 0.0;  // no -0
}

std::optional<ExactEstimate> exact_estimate(const ExtremeProblem& problem) {
  const ident::Method method = problem.scene.identify.method;
  if (method == ident::Method::likelihood || method == ident::Method::newton) {
    return fit_exactly(*problem.plan(ident::Solver::automatic), problem.sets, problem.truth);
  }
  return identify_exactly(*problem.plan(ident::Solver::qr), problem.sets);
}

Measured measure(const ExtremeProblem& problem, Way way, const std::optional<ExactEstimate>& exact) {
  const ident::Solution solution = solved(problem, way);
  Measured out;
  out.method = ident::name(problem.scene.identify.method);
  out.solver = is_svd(way) ? name(way) : solution.used.solver;
  out.lines = solution.fit.lines;
  out.unknowns = problem.truth.size();
  out.digits_kept = out.digits_true = nan;
  out.digits_stated = solution.fit.digits;
  out.condition = exact ? exact->condition : nan;
  out.rank = solution.fit.rank;
  out.seconds = solution.runtime_s.assemble + solution.runtime_s.solve;
  out.bytes = solution.used.accumulator_bytes;
  out.status = solution.status;
  out.warned = !solution.warnings.empty();
  if (solution.unknowns.size() != problem.truth.size()) return out;
  if (exact) out.digits_kept = digits(kept_error(solution, *exact));
  out.digits_true = digits(worst_error(solution, problem));
  if (!is_svd(way)) out.verdict = judged(solution, problem);
  return out;
}

}  // namespace jointid::stability

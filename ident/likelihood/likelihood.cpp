#include "ident/likelihood/likelihood.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "ident/likelihood/bundle.hpp"
#include "ident/likelihood/covariance.hpp"
#include "ident/likelihood/estimator.hpp"
#include "ident/likelihood/likelihood_plan.hpp"
#include "ident/likelihood/variance_sources.hpp"
#include "ident/scene_failure.hpp"
#include "ident/true_values.hpp"

namespace jointid::ident {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

void check_interrupt(const Control& control) {
  if (control.interrupted && control.interrupted()) throw Interrupted();
}

/// The scene's start, or empty where its matrices do not fix every unknown.
std::vector<double> scene_start(const Plan& plan) {
  const auto values = true_values(plan.restriction, plan.scene.identify.start);
  std::vector<double> theta;
  for (std::size_t column = 0; column < plan.columns->size(); ++column) {
    const auto& value = values[plan.columns->unknown_of(column)];
    const auto kind = plan.restriction.unknowns[plan.columns->unknown_of(column)].kind;
    if (!value && plan.scene.identify.start.contains(kind)) {
      fail(plan.scene, "[identify] start", "its matrices do not fix " + plan.columns->name(column, plan.restriction),
           "give matrices that follow the joint's pattern");
    }
    theta.push_back(value.value_or(0.0) / plan.unscale(column));
  }
  return theta;
}

std::vector<double> linear_start(Plan& plan, const Control& control) {
  Control quick = control;
  quick.detail = Detail::estimates;
  const Solution first = solve(*plan.likelihood->start, quick);
  std::vector<double> theta(plan.columns->size(), 0.0);
  for (std::size_t column = 0; column < first.unknowns.size(); ++column) {
    const double value = first.unknowns[column].value;
    theta[column] = std::isfinite(value) ? value / plan.unscale(column) : 0.0;
  }
  return theta;
}

LikelihoodFit fit_by_solver(Plan& plan, std::vector<double> theta, const Control& control) {
  Observations& observations = *plan.likelihood->observations;
  const double omega0 = plan.assembly_spec.omega0;
  const FitWatcher watch = [&](std::size_t) { check_interrupt(control); };
  LikelihoodEstimator estimator(observations, plan.restriction, *plan.columns, omega0, control.threads);
  if (plan.solver == "gauss-helmert") return estimator.run(std::move(theta), watch);
  LikelihoodFit whitened = estimator.run_whitened(std::move(theta), watch);
  if constexpr (JOINTID_HAVE_CERES) {
    if (plan.solver == "ceres") return adjust_bundle(observations, plan.restriction, *plan.columns, omega0, whitened, watch);
  }
  return whitened;
}

ChiSquare chi_square_of(const Observations& observations, const LikelihoodFit& fit) {
  ChiSquare out;
  for (std::size_t i = 0; i < fit.line_cost.size(); ++i) {
    const double redundancy = observations.lines()[i].redundancy(observations.layout());
    out.by_line.push_back(redundancy > 0.0 ? fit.line_cost[i] / redundancy : std::numeric_limits<double>::quiet_NaN());
    if (redundancy <= 0.0) continue;
    out.value += fit.line_cost[i];
    out.degrees_of_freedom += redundancy;
    if (fit.line_weight[i] < 0.5) ++out.outlying_lines;
  }
  out.degrees_of_freedom -= static_cast<double>(fit.theta.size());
  return out;
}

}  // namespace

void solve_likelihood(Plan& plan, const Control& control, Solution& out) {
  const Clock::time_point start = Clock::now();
  Observations& observations = *plan.likelihood->observations;
  std::vector<double> theta = plan.likelihood->start ? linear_start(plan, control) : scene_start(plan);
  const Clock::time_point reading = Clock::now();
  observations.read(plan.lines, [&](std::size_t) { check_interrupt(control); });
  out.runtime_s.read = seconds_since(reading);
  const LikelihoodFit fit = fit_by_solver(plan, std::move(theta), control);
  out.runtime_s.solve = seconds_since(start) - out.runtime_s.read;
  const Eigen::MatrixXd covariance = covariance_of(fit.information);
  LinearSolution linear;
  linear.y = fit.theta;
  linear.rank = fit.theta.size();
  interpret(plan, linear, out);
  for (std::size_t column = 0; column < fit.theta.size(); ++column) {
    Estimate& estimate = out.unknowns[column];
    const auto c = static_cast<Eigen::Index>(column);
    const double error = std::sqrt(covariance(c, c)) * plan.unscale(column);
    estimate.std_error = error;
    estimate.ci95 = {estimate.value - 1.959963984540054 * error, estimate.value + 1.959963984540054 * error};
  }
  if (!fit.converged) {
    out.status = Status::not_converged;
    out.message = "The likelihood did not settle.";
  }
  out.variances = variance_sources(plan);
  out.fit.lines = plan.lines.size();
  for (const LineData& line : observations.lines()) out.fit.equations_used += line.measured / 2;
  out.fit.iterations = fit.iterations;
  out.used.accumulator_bytes = observations.bytes() + fit.bytes;
  out.fit.chi_square = chi_square_of(observations, fit);
}

}  // namespace jointid::ident

#include "ident/likelihood/likelihood.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <tuple>

#include "ident/likelihood/covariance.hpp"
#include "ident/likelihood/estimator.hpp"
#include "ident/likelihood/likelihood_plan.hpp"
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

/// Linear estimates with one weighting after the other, then the scene's start scaled.
std::optional<std::vector<double>> start_number(Plan& plan, std::size_t k, const Control& control) {
  using enum weighting::Weighting;
  constexpr std::array<std::pair<weighting::Weighting, double>, 4> linear = {{{wb, 0.0}, {wbg, 0.0}, {wbs, 0.1}, {wa, 0.0}}};
  constexpr std::array<double, 5> factors = {1.0, 0.3, 3.0, 0.1, 10.0};
  std::vector<double> theta;
  if (Plan* start = plan.likelihood->start.get()) {
    if (k >= linear.size()) return std::nullopt;
    std::tie(start->assembly_spec.weighting, start->assembly_spec.delta) = linear[k];
    Control quick = control;
    quick.detail = Detail::estimates;
    const Solution first = solve(*start, quick);
    for (std::size_t column = 0; column < plan.columns->size(); ++column) {
      const double value = column < first.unknowns.size() ? first.unknowns[column].value : 0.0;
      theta.push_back(std::isfinite(value) ? value / plan.unscale(column) : 0.0);
    }
  } else {
    if (k >= factors.size()) return std::nullopt;
    theta = scene_start(plan);
    for (double& value : theta) value *= factors[k];
  }
  return theta;
}

ChiSquare chi_square_of(const Observations& observations, const LikelihoodFit& fit) {
  ChiSquare out;
  for (std::size_t i = 0; i < fit.line_cost.size(); ++i) {
    const double redundancy = observations.lines()[i].redundancy(observations.layout());
    const bool used = fit.line_weight[i] > 0.0;
    out.by_line.push_back(used ? fit.line_cost[i] / redundancy : std::numeric_limits<double>::quiet_NaN());
    if (!used) continue;
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
  const Clock::time_point reading = Clock::now();
  observations.read(plan.lines, [&](std::size_t) { check_interrupt(control); });
  out.runtime_s.read = seconds_since(reading);
  LikelihoodEstimator estimator(observations, plan.restriction, *plan.columns, plan.assembly_spec.omega0, control.threads);
  const LikelihoodFit fit = estimator.run([&](std::size_t k) { return start_number(plan, k, control); }, [&](std::size_t) { check_interrupt(control); });
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
  out.fit.lines = plan.lines.size();
  for (std::size_t i = 0; i < fit.line_weight.size(); ++i) {
    if (fit.line_weight[i] > 0.0) out.fit.equations_used += observations.lines()[i].measured / 2;
  }
  out.fit.iterations = fit.iterations;
  out.fit.chi_square = chi_square_of(observations, fit);
}

}  // namespace jointid::ident

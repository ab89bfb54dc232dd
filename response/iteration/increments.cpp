#include "response/iteration/increments.hpp"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "dense/real_lu.hpp"

namespace jointid::response {
namespace {

using Eigen::VectorXd;

constexpr int most_halved = 20;
constexpr int most_steps_of_increment = 40;
constexpr double residual_at_rounding = 3e-15;  ///< of ‖Q‖

/// The structure with α times the joints' forces: G → αG, and the free motion stays.
HarmonicLine with_joints(HarmonicLine line, double alpha) {
  for (HarmonicLine::One& one : line.harmonics) one.joints *= alpha;
  return line;
}

/// Extrapolations through the last 1, 2, 3 of the solutions, which are one increment apart.
VectorXd extrapolated(const std::vector<VectorXd>& solutions, std::size_t through) {
  const std::size_t last = solutions.size() - 1;
  if (through == 1) return solutions[last];
  if (through == 2) return 2.0 * solutions[last] - solutions[last - 1];
  return 3.0 * solutions[last] - 3.0 * solutions[last - 1] + solutions[last - 2];
}

VectorXd estimated(Estimate estimate, const std::vector<VectorXd>& solutions, const CondensedEquations& equations,
                   const HarmonicLine& line, double level) {
  const std::size_t known = std::min<std::size_t>(solutions.size(), 3);
  if (estimate != Estimate::best) return extrapolated(solutions, std::min(known, static_cast<std::size_t>(estimate) + 1));
  VectorXd chosen;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t through = 1; through <= known; ++through) {
    VectorXd tried = extrapolated(solutions, through);
    const double error = equations.evaluate(line, level, tried).residual.norm();
    if (!(error < least) && chosen.size() > 0) continue;
    least = error;
    chosen = std::move(tried);
  }
  return chosen;
}

}  // namespace

std::string_view word(Increment increment) { return increment == Increment::force ? "force increment" : "joint increment"; }

std::string_view word(Estimate estimate) {
  switch (estimate) {
    case Estimate::direct:
      return "direct";
    case Estimate::linear:
      return "linear";
    case Estimate::quadratic:
      return "quadratic";
    case Estimate::best:
      return "best";
  }
  return "";
}

NewtonRaphson newton_raphson(const CondensedEquations& equations, const HarmonicLine& line, double level, VectorXd start,
                             const NewtonRaphsonOptions& options) {
  NewtonRaphson run;
  run.motion = std::move(start);
  CondensedEquations::Value value = equations.evaluate(line, level, run.motion);
  while (run.steps < options.most_steps) {
    ++run.steps;
    const VectorXd step = -dense::RealLu(value.by_motion).solve(value.residual);
    if (!step.allFinite()) return run;
    const double size = value.residual.norm();
    const auto balances = [&](const VectorXd& motion) {
      return step.norm() <= options.tolerance * motion.norm() || value.residual.norm() <= residual_at_rounding * motion.norm();
    };
    double share = 1.0;
    VectorXd reached = run.motion + step;
    value = equations.evaluate(line, level, reached);
    for (int i = 0; i < most_halved && !balances(reached) && !(value.residual.norm() < size); ++i) {
      share *= 0.5;
      reached = run.motion + share * step;
      value = equations.evaluate(line, level, reached);
    }
    run.motion = std::move(reached);
    run.converged = balances(run.motion);
    if (run.converged) return run;
  }
  return run;
}

IncrementRun increments(Increment increment, Estimate estimate, int count, const CondensedEquations& equations,
                        const HarmonicLine& line, double level) {
  const bool force = increment == Increment::force;
  IncrementRun run;
  std::vector<VectorXd> solutions;
  if (!force) solutions.push_back(equations.free(line, level));
  for (int i = 1; i <= count; ++i) {
    run.reached = static_cast<double>(i) / count;
    const HarmonicLine scaled = with_joints(line, force ? 1.0 : run.reached);
    const double now = force ? run.reached * level : level;
    VectorXd start = solutions.empty() ? equations.stuck(scaled, now) : estimated(estimate, solutions, equations, scaled, now);
    NewtonRaphson found = newton_raphson(equations, scaled, now, std::move(start), {.most_steps = most_steps_of_increment});
    run.steps += found.steps;
    run.converged = found.converged;
    run.motion = found.motion;
    if (!found.converged) return run;
    solutions.push_back(std::move(found.motion));
    if (solutions.size() > 3) solutions.erase(solutions.begin());
  }
  return run;
}

}  // namespace jointid::response

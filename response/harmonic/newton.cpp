#include "response/harmonic/newton.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/stop_scope.hpp"
#include "dense/real_lu.hpp"

namespace jointid::response {
namespace {

constexpr int most_step_halvings = 12;
constexpr double enough_decrease = 1e-4;
constexpr double step_at_rounding = 1e-9;  ///< of a step that changes the residual by its rounding alone, however stiff the joint

/// For each unknown 1/(largest |b| and |Q| of its joint).
Eigen::VectorXd weights(const CondensedEquations& equations, const HarmonicLine& line, double level,
                        const Eigen::VectorXd& motion) {
  const Eigen::VectorXd driven = equations.free(line, level).cwiseAbs(), moved = motion.cwiseAbs();
  const Eigen::Index size = equations.harmonics().unknowns();
  Eigen::VectorXd weights(motion.size());
  const double all = std::max(driven.maxCoeff(), moved.maxCoeff());
  for (Eigen::Index j = 0; j < motion.size(); j += size) {
    const double own = std::max(driven.segment(j, size).maxCoeff(), moved.segment(j, size).maxCoeff());
    weights.segment(j, size).setConstant(1.0 / std::max({own, 1e-12 * all, 1e-300}));
  }
  return weights;
}

}  // namespace

NewtonResult newton(const CondensedEquations& equations, const HarmonicLine& line, double level, Eigen::VectorXd start,
                    const NewtonOptions& options) {
  NewtonResult result;
  result.motion = std::move(start);
  CondensedEquations::Value value = equations.evaluate(line, level, result.motion);
  for (; result.steps < options.most_steps; ++result.steps) {
    stop_point();
    const Eigen::ArrayXd weight = weights(equations, line, level, result.motion).array();
    const double size = (weight * value.residual.array()).matrix().norm();
    result.residual = size;
    if (!std::isfinite(size)) return result;
    const Eigen::VectorXd step = -dense::RealLu(value.by_motion).solve(value.residual);
    if (!step.allFinite()) return result;
    const double change = (weight * step.array()).abs().maxCoeff();

    double share = 1.0;
    CondensedEquations::Value next = equations.evaluate(line, level, result.motion + step);
    const auto worse = [&] {
      const double now = (weight * next.residual.array()).matrix().norm();
      return !(now <= (1.0 - enough_decrease * share) * size);
    };
    if (change <= options.tolerance) {
      result.motion += step;
      result.residual = (weight * next.residual.array()).matrix().norm();
      result.converged = true;
      return result;
    }
    for (int i = 0; i < most_step_halvings && worse(); ++i) {
      share *= 0.5;
      next = equations.evaluate(line, level, result.motion + share * step);
    }
    if (worse()) {
      result.converged = change <= step_at_rounding;  // the residual cannot fall any more: at rounding, or caught
      return result;
    }
    result.motion += share * step;
    value = std::move(next);
  }
  return result;
}

}  // namespace jointid::response

#include "response/harmonic/attempts.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "friction/law/laws.hpp"
#include "friction/path/series.hpp"

namespace jointid::response {
namespace {

constexpr double lowest_share = 1e-3;  ///< of the level, where levels begin
constexpr double smallest_growth = 1.005;
constexpr double negligible_spring = 1e4;  ///< stiffness over that of the joint

/// Levels from low to the one asked for, each from the last motion in proportion; their growth is halved when Newton fails.
NewtonResult along_levels(const CondensedEquations& equations, const HarmonicLine& line, double level, int& steps) {
  double now = lowest_share * level, growth = 2.0;
  NewtonResult at = newton(equations, line, now, equations.stuck(line, now));
  steps += at.steps;
  if (!at.converged) at = newton(equations, line, now, equations.free(line, now));
  while (at.converged && now < level && growth > smallest_growth) {
    const double next = std::min(level, now * growth);
    NewtonResult reached = newton(equations, line, next, at.motion * (next / now), {.most_steps = 20});
    steps += reached.steps;
    if (reached.converged) {
      at = std::move(reached);
      now = next;
      growth = std::min(2.0, growth * growth);
    } else {
      growth = std::sqrt(growth);
    }
  }
  at.converged = at.converged && now >= level;
  return at;
}

/// The joints, each friction element with a spring in series.
CondensedEquations softened(const CondensedEquations& equations, double spring) {
  const double values[] = {spring};
  const std::shared_ptr<const friction::Element> soft = friction::make_element("spring", values);
  std::vector<Joint> joints;
  for (const JointForce& force : equations.joints()) {
    joints.push_back(force.joint());
    auto& friction = joints.back().friction;
    if (friction) friction = std::make_shared<friction::Series>(friction::Parts{friction, soft});
  }
  return {std::move(joints), equations.harmonics()};
}

/// Springs in series with the joints, from as soft as the structure to where they do not matter, each from the last motion; then
/// none.
NewtonResult along_stiffness(const CondensedEquations& equations, const HarmonicLine& line, double level, int& steps) {
  double flexibility = 0.0, stiffest = 0.0;
  for (const HarmonicLine::One& one : line.harmonics) flexibility = std::max(flexibility, one.joints.cwiseAbs().maxCoeff());
  for (const JointForce& joint : equations.joints()) stiffest = std::max(stiffest, joint.joint().stuck_stiffness());
  double spring = 1.0 / flexibility, growth = 4.0;
  const auto attempt = [&](double stiffness, const Eigen::VectorXd& start) {
    NewtonResult reached = newton(softened(equations, stiffness), line, level, start, {.most_steps = 25});
    steps += reached.steps;
    return reached;
  };
  if (!std::isfinite(spring) || !std::isfinite(negligible_spring * stiffest)) return {};
  NewtonResult at = attempt(spring, equations.free(line, level));
  while (at.converged && spring < negligible_spring * stiffest && growth > smallest_growth) {
    NewtonResult reached = attempt(spring * growth, at.motion);
    if (reached.converged) {
      at = std::move(reached);
      spring *= growth;
      growth = std::min(4.0, growth * growth);
    } else {
      growth = std::sqrt(growth);
    }
  }
  if (!at.converged) return at;
  NewtonResult last = newton(equations, line, level, at.motion);
  steps += last.steps;
  return last;
}

/// The lowest harmonic alone first, then one more each time (R4.7.3).
NewtonResult order_by_order(const CondensedEquations& equations, const HarmonicLine& line, double level, int& steps) {
  const std::vector<int>& all = equations.harmonics().numbers();
  std::vector<Joint> joints;
  for (const JointForce& joint : equations.joints()) joints.push_back(joint.joint());
  NewtonResult last;
  Eigen::MatrixXcd amplitudes;
  std::vector<int> known;
  for (std::size_t count = all.front() == 0 ? 2 : 1; count <= all.size(); ++count) {
    const CondensedEquations part(joints, Harmonics({all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)}));
    HarmonicLine lines = line;
    lines.harmonics.resize(count);
    NewtonResult next = newton(part, lines, level, known.empty() ? part.stuck(lines, level) : embedded(part, known, amplitudes),
                               {.most_steps = 30});
    steps += next.steps;
    if (known.empty() && !next.converged) next = newton(part, lines, level, part.free(lines, level), {.most_steps = 30});
    last = std::move(next);
    known = part.harmonics().numbers();
    amplitudes = part.amplitudes(last.motion);
  }
  return last;
}

}  // namespace

Eigen::VectorXd embedded(const CondensedEquations& equations, const std::vector<int>& harmonics,
                         const Eigen::MatrixXcd& amplitudes) {
  Eigen::MatrixXcd all = Eigen::MatrixXcd::Zero(equations.harmonics().size(), amplitudes.cols());
  for (std::size_t i = 0; i < harmonics.size(); ++i) {
    const Eigen::Index n = equations.harmonics().find(harmonics[i]);
    if (n >= 0) all.row(n) = amplitudes.row(at(i));
  }
  return equations.pack(all);
}

Attempt attempt_all(const CondensedEquations& equations, const HarmonicLine& line, double level,
                    const HarmonicSolution* neighbour) {
  Attempt attempt;
  const auto converges = [&](Start start, NewtonResult result) {
    attempt.start = start;
    attempt.steps += result.steps;
    attempt.result = std::move(result);
    return attempt.result.converged;
  };
  const auto from = [&](const Eigen::VectorXd& motion) { return newton(equations, line, level, motion); };
  if (neighbour != nullptr && neighbour->converged &&
      converges(Start::neighbour, from(embedded(equations, neighbour->harmonics, neighbour->joint_motion)))) {
    return attempt;
  }
  const Eigen::VectorXd stuck = equations.stuck(line, level), free = equations.free(line, level);
  const double error_stuck = equations.evaluate(line, level, stuck).residual.norm();
  const double error_free = equations.evaluate(line, level, free).residual.norm();
  const bool stuck_first = error_stuck <= error_free;
  if (converges(stuck_first ? Start::stuck : Start::free, from(stuck_first ? stuck : free))) return attempt;
  if (converges(stuck_first ? Start::free : Start::stuck, from(stuck_first ? free : stuck))) return attempt;
  int steps = 0;
  if (converges(Start::levels, along_levels(equations, line, level, steps))) {
    attempt.steps += steps;
    return attempt;
  }
  if (converges(Start::stiffness, along_stiffness(equations, line, level, steps))) {
    attempt.steps += steps;
    return attempt;
  }
  converges(Start::harmonics, order_by_order(equations, line, level, steps));
  attempt.steps += steps;
  return attempt;
}

}  // namespace jointid::response

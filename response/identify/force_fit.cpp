#include "response/identify/force_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "base/error.hpp"
#include "base/statistics.hpp"
#include "friction/fit/fit_start.hpp"
#include "minimise/gauss_newton.hpp"
#include "response/fourier/joint_force.hpp"
#include "response/identify/law_unknowns.hpp"

namespace jointid::response {
namespace {

constexpr std::size_t followed_starts = 3;

/// Forces of one joint at the measured motions.
class ForceResiduals {
 public:
  ForceResiduals(const std::vector<DirectStep>& steps, Eigen::Index joint) {
    for (const DirectStep& step : steps) {
      const Harmonics harmonics(step.harmonics);
      points_.push_back(
          {step.omega, Motion(harmonics, step.joint_motion.col(joint)), step.joint_force.col(joint), deviation(step, joint)});
      rows_ += harmonics.unknowns();
    }
  }

  Eigen::Index rows() const { return rows_; }

  std::optional<minimise::Linearised> evaluate(const LawUnknowns& unknowns, const Eigen::VectorXd& numbers) const {
    const auto joints = unknowns.at_numbers(numbers);
    if (!joints) return std::nullopt;
    const JointForce force(joints->front());
    const Eigen::VectorXd slopes = unknowns.slopes(numbers);
    minimise::Linearised out = {Eigen::VectorXd(rows_), Eigen::MatrixXd(rows_, unknowns.size())};
    Eigen::Index row = 0;
    for (const Point& point : points_) {
      const Harmonics& harmonics = point.motion.harmonics();
      const ForceHarmonics found = force.evaluate(point.motion, point.omega, harmonics, true);
      const Eigen::VectorXd deviation = harmonics.pack(point.deviation), missing = harmonics.pack(found.force - point.force);
      out.residual.segment(row, missing.size()) = missing.cwiseQuotient(deviation);
      for (Eigen::Index i = 0; i < unknowns.size(); ++i) {
        const Eigen::Index column = at(unknowns.unknown(i).parameter.parameter);
        out.jacobian.col(i).segment(row, missing.size()) =
            slopes(i) * harmonics.pack(found.by_parameters.col(column)).cwiseQuotient(deviation);
      }
      row += missing.size();
    }
    if (!out.residual.allFinite() || !out.jacobian.allFinite()) return std::nullopt;
    return out;
  }

 private:
  /// √(σ_F² + |F/Q|²σ_Q²): an error of the motion is one of the force along a secant.
  static Eigen::VectorXcd deviation(const DirectStep& step, Eigen::Index joint) {
    Eigen::VectorXcd all = step.force_deviation.col(joint);
    for (Eigen::Index n = 0; n < all.size(); ++n) {
      const double secant = std::abs(step.joint_force(n, joint) / step.joint_motion(n, joint));
      const Complex motion = secant * step.motion_deviation(n, joint);
      all(n) = {std::hypot(all(n).real(), motion.real()), std::hypot(all(n).imag(), motion.imag())};
    }
    return all;
  }

  struct Point {
    double omega;
    Motion motion;
    Eigen::VectorXcd force, deviation;
  };
  std::vector<Point> points_;
  Eigen::Index rows_ = 0;
};

/// Stiffness of the third of the steps with the smallest motions, largest force; of those steps whose F₁/Q₁ is known to 30 % if
/// there are any.
friction::Features features_of(const std::vector<DirectStep>& steps, Eigen::Index joint, const Joint& beside,
                               bool only_known = true) {
  constexpr double known = 0.3;
  constexpr std::size_t fewest = 3;
  std::vector<std::pair<double, double>> by_motion;
  double limit = 0.0;
  for (const DirectStep& step : steps) {
    const Eigen::Index first = Harmonics(step.harmonics).find(1);
    if (first < 0) continue;
    const Complex motion = step.joint_motion(first, joint), friction = step.joint_force(first, joint) - beside.stiffness * motion;
    if (only_known && std::abs(step.equivalent_deviation(joint)) > known * std::abs(friction / motion)) continue;
    by_motion.emplace_back(std::abs(motion), std::abs(friction / motion));
    limit = std::max(limit, std::abs(friction));
  }
  if (only_known && by_motion.size() < fewest) return features_of(steps, joint, beside, false);
  if (by_motion.empty()) {
    throw InputError({.kind = ErrorKind::data,
                      .file = "",
                      .place = "measured states",
                      .problem = "none has harmonic 1",
                      .remedy = "give the first harmonic of the responses, or values of the law to start with"});
  }
  std::ranges::sort(by_motion);
  std::vector<double> stiffness;
  for (std::size_t i = 0; i < std::max<std::size_t>(1, by_motion.size() / 3); ++i) stiffness.push_back(by_motion[i].second);
  return {median(stiffness), limit};
}

/// Unknowns whose start lies inside all bounds; those at one, such as a start of 0, are known.
LawUnknowns unknowns_inside(const Joint& joint) {
  std::vector<JointParameter> free;
  const auto parameters = joint.friction->parameters();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (parameters[i].value > parameters[i].lower && parameters[i].value < parameters[i].upper) free.push_back({0, i});
  }
  return {{joint}, free};
}

struct RankedStart {
  double chi_square;
  LawUnknowns unknowns;
};

std::vector<RankedStart> ranked_starts(const ForceResiduals& residuals, const std::string& law,
                                       const friction::Features& features, const Joint& beside) {
  std::vector<RankedStart> ranked;
  for (auto& element : friction::family(law).starts(features)) {
    Joint joint = beside;
    joint.friction = std::move(element);
    LawUnknowns unknowns = unknowns_inside(joint);
    const auto value = residuals.evaluate(unknowns, unknowns.start());
    if (value) ranked.push_back({value->residual.squaredNorm(), std::move(unknowns)});
  }
  std::ranges::sort(ranked, {}, &RankedStart::chi_square);
  return ranked;
}

}  // namespace

ForceFit fit_forces(const std::vector<DirectStep>& steps, std::size_t index, const std::string& law, const Joint& beside) {
  const ForceResiduals residuals(steps, at(index));
  const auto ranked = ranked_starts(residuals, law, features_of(steps, at(index), beside), beside);
  ForceFit best;
  best.joint = beside;
  best.numbers = residuals.rows();
  best.chi_square = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < std::min(followed_starts, ranked.size()); ++i) {
    const LawUnknowns& unknowns = ranked[i].unknowns;
    best.family.push_back(unknowns.joints().front());
    const auto evaluate = [&](const Eigen::VectorXd& numbers) { return residuals.evaluate(unknowns, numbers); };
    const minimise::GaussNewtonResult found =
        minimise::gauss_newton(evaluate, unknowns.start(), {.most_steps = 40, .tolerance = 1e-6});
    const double chi_square = found.at.residual.squaredNorm();
    if (!(chi_square < best.chi_square)) continue;
    best.chi_square = chi_square;
    best.converged = found.converged;
    best.joint = unknowns.at_numbers(found.unknowns)->front();
  }
  return best;
}

}  // namespace jointid::response

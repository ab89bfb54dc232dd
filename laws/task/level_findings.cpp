#include "laws/task/level_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/statistics.hpp"

namespace jointid::laws {

bool OneSidedJoint::is_told() const { return freedom > 0 && chi_square > chi_square_quantile(static_cast<double>(freedom), 4.0); }

std::vector<OneSidedJoint> test_even_harmonics(const std::vector<response::DirectStep>& steps, Eigen::Index joints) {
  std::vector<OneSidedJoint> all;
  for (Eigen::Index j = 0; j < joints; ++j) {
    OneSidedJoint one;
    one.joint = static_cast<std::size_t>(j);
    for (const response::DirectStep& step : steps) {
      const Eigen::Index first = response::Harmonics(step.harmonics).find(1);
      for (std::size_t n = 0; n < step.harmonics.size(); ++n) {
        if (step.harmonics[n] == 0 || step.harmonics[n] % 2 == 1) continue;
        const Complex force = step.joint_force(at(n), j), deviation = step.force_deviation(at(n), j);
        one.chi_square += std::pow(force.real() / deviation.real(), 2) + std::pow(force.imag() / deviation.imag(), 2);
        one.freedom += 2;
        if (first >= 0) one.largest_share = std::max(one.largest_share, std::abs(force / step.joint_force(first, j)));
      }
    }
    all.push_back(one);
  }
  return all;
}

std::string one_sided_text(const OneSidedJoint& of, const std::string& joint) {
  return fmt::format(
      "{}: its force has even harmonics, up to {:.2g} % of F₁ (χ² = {:.4g} of {}): the joint is not the same in both "
      "directions, by a residual preload, a gap or slack. The laws here are",
      joint, 100.0 * of.largest_share, of.chi_square, static_cast<long>(of.freedom));
}

std::string drift_text(const response::LevelDrift& drift, const LawScene& scene, const response::LawUnknowns& unknowns) {
  std::string changes;
  for (Eigen::Index i = 0; i < unknowns.size(); ++i) {
    if (!std::isfinite(drift.deviation(i)) || std::abs(drift.change(i)) < 2.0 * drift.deviation(i)) continue;
    changes += fmt::format("{}{} {} {:+.2g} % ± {:.1g} %", changes.empty() ? ": " : ", ",
                           scene.joints[unknowns.unknown(i).parameter.joint].beside.name, unknowns.parameter(i).name,
                           100.0 * drift.change(i), 100.0 * drift.deviation(i));
  }
  return fmt::format(
      "{} speaks for another joint than all other levels (χ² would fall by {:.4g} with parameters of its own, {:.3g} is "
      "chance){}. The preload drifted, or forces or responses of that level are off",
      scene.levels[drift.level].name, drift.chi_square, chi_square_quantile(static_cast<double>(drift.freedom), 4.0), changes);
}

}  // namespace jointid::laws

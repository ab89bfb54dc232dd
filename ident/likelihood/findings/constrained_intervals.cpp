#include "ident/likelihood/findings/constrained_intervals.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "base/statistics.hpp"
#include "ident/admissible/profile_interval.hpp"
#include "minimise/linear/covariance.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t most_profiles = 60;  ///< each end of each is a few constrained fits

/// `deviation`: of the scaled unknown by the covariance. What the stated interval has beyond that on either side, for errors that
/// variances do not tell, is kept, within the unknown's own bounds.
void state_scaled(const Plan& plan, std::size_t column, const std::array<double, 2>& scaled, double deviation, Solution& out) {
  Estimate& estimate = out.unknowns[column];
  if (!estimate.ci95) return;
  const double unit = plan.unscale(column), half = normal_95 * deviation * unit;
  const double below = std::max(0.0, estimate.value - half - (*estimate.ci95)[0]);
  const double above = std::max(0.0, (*estimate.ci95)[1] - estimate.value - half);
  std::array<double, 2> ends = {scaled[0] * unit - below, scaled[1] * unit + above};
  for (const auto& [unknown, lower, upper] : plan.scene.identify.bounds) {
    if (unknown == estimate.name) ends = {std::max(ends[0], lower), std::min(ends[1], upper)};
  }
  estimate.ci95 = ends;
}

}  // namespace

void state_constrained_intervals(const Plan& plan, const std::vector<double>& theta, const Eigen::VectorXd& pull,
                                 const Eigen::MatrixXd& information, const Eigen::MatrixXd& covariance, Solution& out) {
  const IdentifySection& asked = plan.scene.identify;
  if (asked.bounds.empty() && asked.inequalities.empty()) return;  // a cone alone: profiles cover 0.92 where these cover 0.94
  const Eigen::VectorXd estimate = Eigen::Map<const Eigen::VectorXd>(theta.data(), at(theta.size())) - covariance * pull;
  if (!estimate.allFinite()) return;
  if (theta.size() <= most_profiles) {
    const auto intervals = profile_intervals(*plan.admissible, estimate, minimise::root_of(information));
    for (std::size_t column = 0; column < theta.size(); ++column) {
      state_scaled(plan, column, intervals[column], std::sqrt(covariance(at(column), at(column))), out);
    }
    return;
  }
  for (const auto& [unknown, lower, upper] : plan.scene.identify.bounds) {
    const auto found = std::ranges::find(out.unknowns, unknown, &Estimate::name);
    const auto column = static_cast<std::size_t>(found - out.unknowns.begin());
    const double unit = plan.unscale(column), deviation = std::sqrt(covariance(at(column), at(column)));
    state_scaled(plan, column, densest_interval(estimate[at(column)], deviation, lower / unit, upper / unit), deviation, out);
  }
}

}  // namespace jointid::ident

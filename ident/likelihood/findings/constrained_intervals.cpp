#include "ident/likelihood/findings/constrained_intervals.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "ident/admissible/profile_interval.hpp"
#include "minimise/linear/covariance.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t most_profiles = 60;  ///< each end of each is a few constrained fits

void state_scaled(const Plan& plan, std::size_t column, const std::array<double, 2>& scaled, Solution& out) {
  if (!out.unknowns[column].ci95) return;
  const double unit = plan.unscale(column);
  out.unknowns[column].ci95 = {scaled[0] * unit, scaled[1] * unit};
}

}  // namespace

void state_constrained_intervals(const Plan& plan, const std::vector<double>& theta, const Eigen::VectorXd& pull,
                                 const Eigen::MatrixXd& information, const Eigen::MatrixXd& covariance, Solution& out) {
  if (plan.admissible->inequalities.empty()) return;
  const Eigen::VectorXd estimate = Eigen::Map<const Eigen::VectorXd>(theta.data(), at(theta.size())) - covariance * pull;
  if (!estimate.allFinite()) return;
  if (theta.size() <= most_profiles) {
    const auto intervals = profile_intervals(*plan.admissible, estimate, minimise::root_of(information));
    for (std::size_t column = 0; column < theta.size(); ++column) state_scaled(plan, column, intervals[column], out);
    return;
  }
  for (const auto& [unknown, lower, upper] : plan.scene.identify.bounds) {
    const auto found = std::ranges::find(out.unknowns, unknown, &Estimate::name);
    const auto column = static_cast<std::size_t>(found - out.unknowns.begin());
    const double unit = plan.unscale(column);
    state_scaled(
        plan, column,
        densest_interval(estimate[at(column)], std::sqrt(covariance(at(column), at(column))), lower / unit, upper / unit), out);
  }
}

}  // namespace jointid::ident

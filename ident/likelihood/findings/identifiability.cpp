#include "ident/likelihood/findings/identifiability.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/findings/findings.hpp"
#include "ident/likelihood/findings/joint_visibility.hpp"
#include "ident/likelihood/findings/weak_combinations.hpp"

namespace jointid::ident {

Eigen::MatrixXd relative_covariance(const Plan& plan, const Eigen::MatrixXd& covariance, const std::vector<double>& values,
                                    const std::vector<std::size_t>& which) {
  const std::vector<double> scales = relative_scales(plan, values);
  const auto n = at(which.size());
  Eigen::MatrixXd out(n, n);
  const auto factor = [&](std::size_t column) { return plan.unscale(column) / (scales[column] > 0.0 ? scales[column] : 1.0); };
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      const std::size_t a = which[static_cast<std::size_t>(i)], b = which[static_cast<std::size_t>(j)];
      out(i, j) = covariance(at(a), at(b)) * factor(a) * factor(b);
    }
  }
  return out;
}

namespace {

/// The combination that is fixed worst as a change of the scaled unknowns.
std::vector<double> weakest_direction(const Plan& plan, const Solution& solution, const WeakCombination& weak) {
  std::vector<double> values, direction(solution.unknowns.size(), 0.0);
  for (const Estimate& estimate : solution.unknowns) values.push_back(estimate.value);
  const std::vector<double> scales = relative_scales(plan, values);
  for (std::size_t column = 0; column < direction.size(); ++column) {
    const auto found = std::ranges::find(weak.worst.names, solution.unknowns[column].name);
    if (found == weak.worst.names.end()) continue;
    direction[column] =
        weak.worst.factors[static_cast<std::size_t>(found - weak.worst.names.begin())] * scales[column] / plan.unscale(column);
  }
  return direction;
}

}  // namespace

Identifiability identifiability_of(const Plan& plan, const LinearisedLikelihood& estimator, const Eigen::MatrixXd& covariance,
                                   double likely, const Solution& out) {
  std::vector<double> values, frequency_hz;
  std::vector<std::string> names;
  std::vector<std::size_t> determined;
  for (std::size_t column = 0; column < out.unknowns.size(); ++column) {
    values.push_back(out.unknowns[column].value);
    if (!out.unknowns[column].determined) continue;
    determined.push_back(column);
    names.push_back(out.unknowns[column].name);
  }
  for (const Line& line : plan.lines) frequency_hz.push_back(line.frequency_hz);
  const Eigen::MatrixXd relative = relative_covariance(plan, covariance, values, determined);
  Identifiability found;
  found.weakest = weak_combinations(relative, names);
  if (!found.weakest.empty()) {
    found.joint = joint_visibility(*likelihood_plan(plan)->observations, estimator, weakest_direction(plan, out, found.weakest.front()));
    found.stiff_pairs = stiff_pairs(*likelihood_plan(plan)->observations, estimator);
  }
  for (Eigen::Index i = 0; i < relative.rows(); ++i) {
    found.largest_relative_error = std::max(found.largest_relative_error, std::sqrt(relative(i, i)));
  }
  found.findings = findings_of(found, out.fit, out.intervals, frequency_hz, likely);
  return found;
}

}  // namespace jointid::ident

#include "ident/judgement/constrained_scatter.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "base/eigen.hpp"
#include "dense/eigen.hpp"
#include "ident/admissible/admissible_linear.hpp"
#include "ident/equations/assemble.hpp"
#include "ident/judgement/line_jackknife.hpp"
#include "minimise/linear/covariance.hpp"
#include "minimise/linear/solve_linear.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// An estimate with and without the constraints.
struct LeftOut {
  VectorXd free, constrained;
  bool is_free_determined = false;
};

std::optional<LeftOut> estimates_without_group(const Plan& plan, std::vector<minimise::Accumulator>& systems, std::size_t group) {
  minimise::Accumulator rest = system_without(plan, systems, {group});
  minimise::LinearSolution linear = solve(plan, rest, minimise::Condition::skip);
  LeftOut out{.free = Eigen::Map<const VectorXd>(linear.y.data(), at(linear.y.size())),
           .constrained = {},
           .is_free_determined = linear.rank == plan.columns->size()};
  if (linear.rank == 0) return std::nullopt;
  bool converged = true;
  constrain(plan, rest, rest.rows_pushed(), linear, converged);
  out.constrained = Eigen::Map<const VectorXd>(linear.y.data(), at(linear.y.size()));
  if (!converged || linear.rank != plan.columns->size() || !out.constrained.allFinite()) return std::nullopt;
  return out;
}

/// Whether ties alone state an unknown.
bool is_stated(const AdmissibleSet& set, Index column) {
  return set.directions.size() > 0 && set.directions.row(column).isZero(0.0);
}

/// Unknowns that inequalities hold get the deviations without constraints; empty if these are not known (no columns).
std::optional<ConstrainedScatter> with_held(const AdmissibleSet& set, MatrixXd constrained, const MatrixXd& free) {
  constexpr double still = 1e-3;  // of the deviations without constraints
  ConstrainedScatter out{std::move(constrained)};
  for (Index c = 0; c < out.deviations.rows(); ++c) {
    if (is_stated(set, c)) continue;
    const double own = out.deviations.row(c).norm();
    if (own > 0.0 && !(free.size() > 0 && own <= still * free.row(c).norm())) continue;
    if (free.size() == 0) return std::nullopt;
    out.deviations.row(c) = free.row(c);
  }
  return out;
}

}  // namespace

std::optional<ConstrainedScatter> constrained_scatter(const Plan& plan, std::size_t most_lines, const Control& control) {
  const std::vector<std::vector<Line>> groups = jackknife_groups(plan, most_lines);
  if (groups.empty()) return std::nullopt;
  std::vector<minimise::Accumulator> systems = systems_of(plan, groups, control);
  const Index n = at(plan.columns->size());
  MatrixXd free(n, at(groups.size())), constrained(n, at(groups.size()));
  bool is_free_determined = true;
  for (std::size_t group = 0; group < groups.size(); ++group) {
    const std::optional<LeftOut> found = estimates_without_group(plan, systems, group);
    if (!found) return std::nullopt;
    free.col(at(group)) = found->free;
    constrained.col(at(group)) = found->constrained;
    is_free_determined = is_free_determined && found->is_free_determined;
  }
  const double scale = std::sqrt(share_of_all(plan, groups));
  const MatrixXd without = is_free_determined ? MatrixXd(scale * jackknife_deviations(free)) : MatrixXd();
  return with_held(*plan.admissible, scale * jackknife_deviations(constrained), without);
}

std::optional<ConstrainedScatter> constrained_scatter(const AdmissibleSet& set, const VectorXd& theta, const MatrixXd& covariance,
                                                      const MatrixXd& root, double unit) {
  const dense::SymmetricEigen eigen = dense::symmetric_eigen(covariance);
  const MatrixXd free = eigen.vectors * eigen.values.cwiseMax(0.0).cwiseSqrt().asDiagonal();
  if (!free.allFinite()) return std::nullopt;
  MatrixXd constrained(free.rows(), free.cols());
  for (Index c = 0; c < free.cols(); ++c) {
    const AdmissibleFit above = nearest_admissible(set, theta + free.col(c), root, unit),
                        below = nearest_admissible(set, theta - free.col(c), root, unit);
    if (!above.converged || !below.converged) return std::nullopt;
    constrained.col(c) = 0.5 * (above.theta - below.theta);
  }
  return with_held(set, std::move(constrained), free);
}

FreeEstimate under_constraints(const Plan& plan, const FreeEstimate& free, const ConstrainedScatter& scatter) {
  FreeEstimate out = free;
  out.covariance = scatter.covariance();
  if (!plan.scene.identify.frequencies_hz.empty()) return out;
  const MatrixXd root = minimise::root_of(minimise::covariance_of(free.covariance));
  const VectorXd theta = Eigen::Map<const VectorXd>(free.theta.data(), at(free.theta.size()));
  if (!root.allFinite()) return out;
  const AdmissibleFit nearest = nearest_admissible(*plan.admissible, theta, root, 1.0);
  if (nearest.converged && nearest.theta.allFinite()) out.theta.assign(nearest.theta.begin(), nearest.theta.end());
  return out;
}

}  // namespace jointid::ident

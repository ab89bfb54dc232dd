#include "ident/likelihood/findings/best_joint.hpp"

#include <algorithm>

#include "base/eigen.hpp"
#include "ident/admissible/admissible_fit.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/findings/joint_part.hpp"
#include "ident/plan/interpret.hpp"
#include "minimise/linear/covariance.hpp"

namespace jointid::ident {
namespace {

/// The joint of the scene's set that is nearest to an estimate on the way, in the metric of its information where there is some.
std::vector<double> joint_within(const AdmissibleSet& set, const std::vector<double>& theta, const Eigen::MatrixXd& information) {
  const Eigen::VectorXd from = Eigen::Map<const Eigen::VectorXd>(theta.data(), at(theta.size()));
  const auto n = at(theta.size());
  const bool informed =
      information.rows() >= n && information.topLeftCorner(n, n).allFinite() && information.diagonal().head(n).minCoeff() > 0.0;
  Eigen::MatrixXd root = from.cwiseAbs().cwiseMax(1e-6 * from.cwiseAbs().maxCoeff()).cwiseMax(1e-300).cwiseInverse().asDiagonal();
  if (informed) root = minimise::root_of(joint_information(information, theta.size()));
  const Eigen::VectorXd nearest = nearest_admissible(set, from, root, 1.0).theta;
  return nearest.allFinite() ? std::vector<double>(nearest.begin(), nearest.end()) : theta;
}

}  // namespace

std::size_t equations_used(const Observations& observations, const std::vector<double>& line_weight) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < observations.lines().size(); ++i) {
    if (line_weight.empty() || line_weight[i] > 0.0) count += observations.lines()[i].measured / 2;
  }
  return count;
}

void BestJoint::tell(const LikelihoodFit& fit, double loss) {
  ++steps_;
  if (!(loss <= least_)) return;
  least_ = loss;
  Solution best = begun_;
  best.status = Status::not_converged;
  minimise::LinearSolution linear;
  linear.y = {fit.theta.begin(), fit.theta.begin() + std::ptrdiff_t(plan_.columns->size())};
  linear.rank = linear.y.size();
  if (plan_.admissible) linear.y = joint_within(*plan_.admissible, linear.y, fit.information);
  interpret(plan_, linear, best);
  best.fit.lines = plan_.lines.size();
  best.fit.equations_used = equations_used(*likelihood_plan(plan_)->observations, {});
  best.fit.iterations = steps_;
  if (std::isfinite(loss)) best.fit.objective = loss;
  best.runtime_s.solve = std::max(0.0, seconds_since(begin_) - best.runtime_s.start);
  control_.so_far(best);
}

}  // namespace jointid::ident

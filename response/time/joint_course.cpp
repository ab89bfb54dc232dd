#include "response/time/joint_course.hpp"

#include <algorithm>
#include <cmath>

#include "dense/real_lu.hpp"
#include "response/time/collocation.hpp"

namespace jointid::response {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int points = Collocation::points;

}  // namespace

JointCourse::JointCourse(LinearFlow& flow, const VectorXd& z, const JointStates& states) : flow_(&flow), states_(&states) {
  double factorial = 1.0;
  for (int k = 0; k <= LinearFlow::terms; ++k) {
    if (k > 1) factorial *= k;
    taylor_.push_back(flow.rows(k) * z / factorial);
  }
  forces_.resize(at(flow.curved().size()) * points);
  for (Index c = 0; c < at(flow.curved().size()); ++c) {
    const Index j = flow.curved()[static_cast<std::size_t>(c)];
    forces_.segment(c * points, points).setConstant((*states_)[static_cast<std::size_t>(j)]->response(taylor_[0][j]).force);
  }
  free_motion(0.0);
  for (int d = 0; d < 3; ++d) start_[d] = motion_[d];
  if (forces_.size() > 0) {
    for (Index c = 0; c < at(flow.curved().size()); ++c) start_[2] += flow.markov(1).col(c) * forces_[c * points];
  }
}

/// Without the curved joints.
void JointCourse::free_motion(double h) {
  for (int d = 0; d < 3; ++d) {
    VectorXd sum = VectorXd::Zero(taylor_[0].size());
    for (int k = LinearFlow::terms; k >= d; --k) {
      const double factor = d == 0 ? 1.0 : d == 1 ? k : k * (k - 1.0);
      sum = sum * h + factor * taylor_[static_cast<std::size_t>(k)];
    }
    motion_[d] = sum;
  }
}

bool JointCourse::meet_laws(double h) {
  const Index curved = at(flow_->curved().size()), size = curved * points;
  const VectorXd& nodes = Collocation::rule().nodes;
  influence_ = flow_->influence(h).nodes;
  VectorXd alone(size);
  for (int i = 0; i < points; ++i) {
    for (Index c = 0; c < curved; ++c) {
      const Index j = flow_->curved()[static_cast<std::size_t>(c)];
      double sum = 0.0;
      for (int k = LinearFlow::terms; k >= 0; --k) sum = sum * nodes[i] * h + taylor_[static_cast<std::size_t>(k)][j];
      alone[c * points + i] = sum;
    }
  }
  tangents_.resize(size);
  double last = friction::infinity;
  for (int iteration = 0; iteration < 30; ++iteration) {
    node_q_ = alone + influence_ * forces_;
    VectorXd residual(size);
    for (Index i = 0; i < size; ++i) {
      const auto j = static_cast<std::size_t>(flow_->curved()[static_cast<std::size_t>(i / points)]);
      const friction::Response law = (*states_)[j]->response(node_q_[i]);
      residual[i] = law.force - forces_[i];
      tangents_[i] = law.tangent;
    }
    const MatrixXd jacobian = MatrixXd::Identity(size, size) - tangents_.asDiagonal() * influence_;
    const VectorXd step = dense::RealLu(jacobian).solve(residual);
    forces_ += step;
    const double change = step.cwiseAbs().maxCoeff(), scale = forces_.cwiseAbs().maxCoeff();
    if (!std::isfinite(change)) return false;
    if (change <= 1e-15 * scale || (iteration > 2 && change >= last && change <= 1e-12 * scale)) {
      node_q_ = alone + influence_ * forces_;
      return true;
    }
    last = change;
  }
  return false;
}

bool JointCourse::solve(double h) {
  length_ = h;
  free_motion(h);
  if (flow_->curved().empty()) return true;
  if (!meet_laws(h)) return false;
  for (std::size_t d = 0; d < 3; ++d) motion_[d] += flow_->influence(h).end[d] * forces_;
  return true;
}

/// What is left beside a straight line is small, so that rounding of the polynomial's coefficients is too.
MatrixXd JointCourse::force_series() const {
  const Index curved = at(flow_->curved().size());
  MatrixXd series = MatrixXd::Zero(curved, points);
  const VectorXd& nodes = Collocation::rule().nodes;
  for (Index c = 0; c < curved; ++c) {
    const Index j = flow_->curved()[static_cast<std::size_t>(c)];
    const friction::Response law = (*states_)[static_cast<std::size_t>(j)]->response(start_[0][j]);
    const double rate = law.tangent * start_[1][j] * length_;
    const VectorXd rest = (forces_.segment(c * points, points).array() - law.force).matrix() - rate * nodes;
    series.row(c) = (Collocation::rule().to_monomials * rest).transpose();
    series(c, 0) += law.force;
    series(c, 1) += rate;
  }
  return series;
}

/// A spring without stiffness at rest has a force as small as one likes: it counts beside the one that accelerates the joint.
double JointCourse::inertia(Index joint, Index curved) const {
  const double mobility = std::abs(flow_->markov(1)(joint, curved));
  return mobility > 0.0 ? std::max(std::abs(start_[2][joint]), std::abs(motion_[2][joint])) / mobility : 0.0;
}

double JointCourse::mismatch() const {
  double worst = 0.0;
  const MatrixXd series = force_series();
  for (Index c = 0; c < series.rows(); ++c) {
    const Index j = flow_->curved()[static_cast<std::size_t>(c)];
    const double force = (*states_)[static_cast<std::size_t>(j)]->response(motion_[0][j]).force;
    double scale = std::max(forces_.segment(c * points, points).cwiseAbs().maxCoeff(), std::abs(force));
    if ((*states_)[static_cast<std::size_t>(j)]->piece().direction == 0) scale = std::max(scale, inertia(j, c));
    if (scale > 0.0) worst = std::max(worst, std::abs(series.row(c).sum() - force) / scale);
  }
  return worst;
}

}  // namespace jointid::response

#include "dense/real_lu.hpp"
#include "response/time/collocation.hpp"
#include "response/time/exact_march.hpp"

namespace jointid::response {

using Eigen::Index;
using Eigen::MatrixXd;

void ExactMarch::follow(const MatrixXd& slopes) {
  slopes_ = slopes;
  const Index n = structure_.coordinates();
  for (Index j = 0; j < structure_.joints(); ++j) {
    JointState& state = *states_[static_cast<std::size_t>(j)];
    state.follow(slopes.cols());
    const double q = structure_.incidence.col(j).dot(z_.head(n));
    slopes_.row(2 * n + j) =
        state.first_slope(q, structure_.incidence.col(j).transpose() * slopes_.topRows(n), slopes_.row(2 * n + j));
  }
}

/// At Gauss's points δf = T′δq + drift, δq = WᵀA^k δz (cᵢh)^k/k! + G δf.
void ExactMarch::follow_slopes(const LinearFlow& flow, const JointCourse& course, const StepMatrices& step) {
  const Index size = slopes_.rows(), parameters = slopes_.cols(), curved = at(flow.curved().size());
  constexpr int points = Collocation::points;
  const double h = course.length();
  MatrixXd forces(curved * points, parameters);
  for (int i = 0; i < points && curved > 0; ++i) {
    const double tau = Collocation::rule().nodes[i] * h;
    MatrixXd rows = flow.rows(LinearFlow::terms).leftCols(size);
    for (int k = LinearFlow::terms; k-- > 0;) rows = rows * (tau / (k + 1)) + flow.rows(k).leftCols(size);
    const MatrixXd dq = rows * slopes_;
    for (Index c = 0; c < curved; ++c) {
      const Index j = flow.curved()[static_cast<std::size_t>(c)], place = c * points + i;
      const JointState& state = *states_[static_cast<std::size_t>(j)];
      forces.row(place) = course.node_tangents()[place] * dq.row(j) + state.drift(course.node_displacements()[place]);
    }
  }
  slopes_ = (step.transition.topLeftCorner(size, size) * slopes_).eval();
  if (curved > 0) {
    const MatrixXd jacobian =
        MatrixXd::Identity(curved * points, curved * points) - course.node_tangents().asDiagonal() * course.influence();
    slopes_ += step.input.topRows(size) * dense::RealLu(jacobian).solve(forces);
  }
  const Index n = structure_.coordinates();
  for (const Index j : flow.curved()) {
    const JointState& state = *states_[static_cast<std::size_t>(j)];
    slopes_.row(2 * n + j) =
        state.response(course.q()[j]).tangent * structure_.incidence.col(j).transpose() * slopes_.topRows(n) +
        state.drift(course.q()[j]);
  }
}

}  // namespace jointid::response

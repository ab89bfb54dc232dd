#include "response/orbit/orbit_figures.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

#include "response/time/collocation.hpp"

namespace jointid::response {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Where row `velocity` of a series changes its sign inside the step.
double turn_inside(const MatrixXd& series, Index velocity) {
  const auto value = [&](double sigma) {
    double sum = 0.0;
    for (Index k = series.cols(); k-- > 0;) sum = sum * sigma + series(velocity, k);
    return sum;
  };
  std::uintmax_t iterations = 60;
  const auto found =
      boost::math::tools::toms748_solve(value, 0.0, 1.0, boost::math::tools::eps_tolerance<double>(50), iterations);
  return 0.5 * (found.first + found.second);
}

void widen(VectorXd& largest, const MarchStep& step) {
  const Instant first = step.motion(0.0), last = step.motion(1.0);
  largest = largest.cwiseMax(first.x.cwiseAbs()).cwiseMax(last.x.cwiseAbs());
  for (Index i = 0; i < largest.size(); ++i) {
    if (!(first.v[i] * last.v[i] < 0.0)) continue;
    const double sigma = turn_inside(step.series, step.coordinates + i);
    largest[i] = std::max(largest[i], std::abs(step.motion(sigma).x[i]));
  }
}

}  // namespace

OrbitFigures figures(const PeriodicProblem& problem, const PeriodicOrbit& orbit, const std::vector<int>& harmonics,
                     const MarchOptions& options) {
  const JointedStructure& structure = problem.structure;
  const Index n = structure.coordinates(), joints = structure.joints(), count = at(harmonics.size());
  OrbitFigures out{
      Eigen::MatrixXcd::Zero(n, count), {}, Eigen::MatrixXcd::Zero(joints, count), VectorXd::Zero(n), VectorXd::Zero(joints)};
  MarchOptions fine = options;
  const int highest = harmonics.empty() ? 1 : std::max(1, std::ranges::max(harmonics));
  fine.longest_step = std::min(fine.longest_step, 2.0 / (highest * problem.omega));  // e^{−inωt} turns by 2 rad in a step at most
  ExactMarch march(structure, problem.force(), fine);
  for (std::size_t j = 0; j < orbit.joints.size(); ++j) march.joint_states()[j] = orbit.joints[j]->clone();
  march.place(0.0, orbit.x, orbit.v, orbit.f);
  const Collocation& rule = Collocation::rule();
  march.march(problem.period(), [&](const MarchStep& step) {
    widen(out.largest, step);
    for (int i = 0; i < Collocation::points; ++i) {
      const Instant motion = step.motion(rule.nodes[i]);
      const double weight = rule.weights[i] * step.length;
      for (Index h = 0; h < count; ++h) {
        const int order = harmonics[static_cast<std::size_t>(h)];
        const Complex factor =
            (order == 0 ? 1.0 : 2.0) * weight / problem.period() * std::polar(1.0, -order * problem.omega * motion.time);
        out.x.col(h) += factor * motion.x;
        out.f.col(h) += factor * motion.f;
      }
      out.loss += weight * motion.f.cwiseProduct(structure.incidence.transpose() * motion.v);
      out.work += weight * march.force().value(motion.time).dot(motion.v);
      out.damping_loss += weight * motion.v.dot(structure.matrices.damping * motion.v);
    }
  });
  out.q = structure.incidence.transpose() * out.x;
  return out;
}

}  // namespace jointid::response

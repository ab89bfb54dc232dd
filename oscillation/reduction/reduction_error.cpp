#include "oscillation/reduction/reduction_error.hpp"

#include <cmath>

#include "base/error.hpp"
#include "base/statistics.hpp"
#include "base/stopwatch.hpp"

namespace jointid::oscillation {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

double energy(const Mechanics& m, const MatrixXd& q, const MatrixXd& v) {
  return 0.5 * (v.cwiseProduct(m.mass * v).sum() + q.cwiseProduct(m.stiffness * q).sum());
}

std::vector<double> times_of(const ComparedMotion& motion) {
  std::vector<double> times = equal_times(motion.length / static_cast<double>(motion.samples), motion.samples);
  for (double& time : times) time += motion.transient;
  return times;
}

}  // namespace

ContactSystem contact_system(const Model& model) { return {model.mechanics, model.drive, model.friction}; }

Model reduced(const Model& full, const ReductionBasis& basis) {
  return {reduced(full.mechanics, basis), full.drive, reduced(full.friction, full.mechanics, basis)};
}

Trajectory trajectory(const Model& model, const ComparedMotion& motion) {
  if (!(motion.length > 0.0) || !(motion.transient >= 0.0) || motion.samples == 0) {
    throw InputError({ErrorKind::usage, "", "transient, length, samples", "are not a window of time", ""});
  }
  const ContactSystem system = contact_system(model);
  const Clock::time_point begin = Clock::now();
  const Motion found =
      integrate(system, system.state(motion.q, motion.v), motion.transient + motion.length, times_of(motion), motion.interrupted);
  const Index n = system.degrees();
  return {found.status, found.samples.topRows(n), found.samples.middleRows(n, n), seconds_since(begin)};
}

Trajectory trajectory(const Model& full, const ReductionBasis& basis, const ComparedMotion& motion) {
  ComparedMotion small = motion;
  small.q = reduced_displacements(full.mechanics, basis, motion.q);
  small.v = reduced_velocities(full.mechanics, basis, motion.v);
  Trajectory out = trajectory(reduced(full, basis), small);
  out.q = (basis.columns * out.q).colwise() + basis.mean;
  out.v = basis.columns * out.v;
  return out;
}

ReductionError reduction_error(const Model& full, const Trajectory& truth, const Trajectory& found, const MatrixXd& observed) {
  ReductionError out{truth.status == MotionEnd::ok ? found.status : truth.status, nan, nan, VectorXd::Constant(observed.rows(), nan),
                     found.seconds};
  if (out.status != MotionEnd::ok) return out;
  const double off = (found.q - truth.q).squaredNorm() + (found.v - truth.v).squaredNorm();
  out.motion = std::sqrt(off / (truth.q.squaredNorm() + truth.v.squaredNorm()));
  out.energy = std::abs(energy(full.mechanics, found.q, found.v) / energy(full.mechanics, truth.q, truth.v) - 1.0);
  if (observed.rows() > 0) out.observed = (observed * (found.q - truth.q)).cwiseAbs().rowwise().maxCoeff();
  return out;
}

}  // namespace jointid::oscillation

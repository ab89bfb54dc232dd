#include "response/time/algorithm_two.hpp"

#include <string>

#include "base/error.hpp"
#include "dense/cholesky.hpp"
#include "dense/eigen.hpp"
#include "response/time/algorithm_one.hpp"

namespace jointid::response {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct StepSides {
  MatrixXd next, now, before;  ///< of x₂, x₁, x₀
};

/// `now` without the joints' forces.
StepSides sides(const JointedStructure& s, double delta, double a, const VectorXd& k_r) {
  const MatrixXd reference = s.incidence * k_r.asDiagonal() * s.incidence.transpose(),
                 stiffness = s.matrices.stiffness + reference;
  const MatrixXd mass = s.matrices.mass / (delta * delta), damping = s.matrices.damping / (2.0 * delta);
  return {mass + damping + a * stiffness, 2.0 * mass - (1.0 - 2.0 * a) * stiffness + reference, damping - mass - a * stiffness};
}

[[noreturn]] void refuse_option(const std::string& place, const std::string& problem, const std::string& remedy) {
  throw InputError({.kind = ErrorKind::usage, .file = {}, .place = place, .problem = problem, .remedy = remedy});
}

}  // namespace

AlgorithmTwo::AlgorithmTwo(JointedStructure structure, ForceHistory force, double delta, const AlgorithmTwoOptions& options)
    : structure_(std::move(structure)), force_(std::move(force)), delta_(delta), options_(options) {
  check(structure_, force_);
  check_step(delta);
  const VectorXd initial = structure_.initial_stiffness();
  if (options_.reference_stiffness.size() == 0) options_.reference_stiffness = initial;
  if (options_.reference_stiffness.size() != initial.size()) {
    refuse_option("k_r", "has " + std::to_string(options_.reference_stiffness.size()) + " values",
                  "give one for each joint, or none");
  }
  if (!(options_.weight >= 0.0 && options_.weight <= 0.5)) {
    refuse_option("weight a of Algorithm Two", "is " + std::to_string(options_.weight), "give one from 0 to 0.5");
  }
  for (Index j = 0; j < initial.size(); ++j) {
    if (options_.reference_stiffness[j] < (1.0 - 1e-12) * initial[j]) too_soft_.push_back(j);
  }
  const StepSides step = sides(structure_, delta, options_.weight, options_.reference_stiffness);
  const auto factor = dense::cholesky(step.next);
  if (!factor)
    refuse_option("time step", "M/Δ² + C/2Δ + aK̃ is not positive definite", "look for negative damping, stiffness or k_r");
  lower_ = *factor;
  now_ = step.now;
  before_ = step.before;
  growth_ = spectral_radius(character_matrix(structure_, delta, options_.weight, options_.reference_stiffness, initial));
  paths_ = joint_paths(structure_, options_.loads);
  const VectorXd rest = VectorXd::Zero(structure_.coordinates());
  motion_ = {0.0, rest, rest, VectorXd::Zero(structure_.joints())};
  last_ = rest;
}

void AlgorithmTwo::advance(const VectorXd& x) {
  last_ = motion_.x;
  motion_.time = static_cast<double>(++steps_) * delta_;
  motion_.x = x;
  motion_.v = (x - last_) / delta_;
  const VectorXd q = structure_.incidence.transpose() * x;
  for (Index j = 0; j < q.size(); ++j) {
    JointPath& path = paths_[static_cast<std::size_t>(j)];
    path.set_time(motion_.time);
    motion_.f[j] = path.advance(q[j]).force;
  }
}

void AlgorithmTwo::step() {
  if (steps_ == 0 && options_.starts_by_algorithm_one) {
    AlgorithmOne first(structure_, force_, delta_, options_.loads);
    first.step();
    return advance(first.motion().x);
  }
  const double a = options_.weight, time = static_cast<double>(steps_) * delta_;
  const VectorXd next = force_.value(time + delta_), now = force_.value(time);
  const VectorXd before = steps_ == 0 ? VectorXd(2.0 * now - next) : force_.value(time - delta_);  // straight on before t = 0
  VectorXd right =
      a * (next + before) + (1.0 - 2.0 * a) * now - structure_.incidence * motion_.f + now_ * motion_.x + before_ * last_;
  dense::solve_lower(lower_, right);
  dense::solve_lower_transposed(lower_, right);
  advance(right);
}

MatrixXd character_matrix(const JointedStructure& s, double delta, double weight, const VectorXd& k_r, const VectorXd& tangents) {
  const Index n = s.coordinates();
  StepSides step = sides(s, delta, weight, k_r);
  step.now -= s.incidence * tangents.asDiagonal() * s.incidence.transpose();
  MatrixXd right(n, 2 * n);
  right << step.now, step.before;
  MatrixXd character = MatrixXd::Zero(2 * n, 2 * n);
  character.topRows(n) = dense::solve_positive(step.next, right);
  character.bottomLeftCorner(n, n).setIdentity();
  return character;
}

double spectral_radius(const MatrixXd& matrix) {
  return matrix.size() == 0 ? 0.0 : dense::eigenvalues(matrix).cwiseAbs().maxCoeff();
}

}  // namespace jointid::response

#include "response/harmonic/harmonic_balance.hpp"

#include <algorithm>
#include <numbers>
#include <string>
#include <utility>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "response/harmonic/attempts.hpp"

namespace jointid::response {
namespace {

constexpr Eigen::Index looked_ahead = 3;  ///< harmonics beyond the last one, of each kind that the force calls for

[[noreturn]] void fail(std::string place, std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::usage,
                    .file = "",
                    .place = std::move(place),
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

bool is_odd(const std::vector<int>& numbers) {
  return std::ranges::all_of(numbers, [](int n) { return n % 2 == 1; });
}

}  // namespace

std::string_view word(Start start) {
  switch (start) {
    case Start::neighbour:
      return "neighbour";
    case Start::stuck:
      return "stuck";
    case Start::free:
      return "free";
    case Start::levels:
      return "levels";
    case Start::stiffness:
      return "stiffness";
    case Start::harmonics:
      return "harmonics";
  }
  return "";
}

HarmonicBalance::HarmonicBalance(std::shared_ptr<const Receptance> structure, std::vector<Joint> joints, Excitation force,
                                 HarmonicChoice choice)
    : structure_(std::move(structure)), joints_(std::move(joints)), force_(std::move(force)), choice_(std::move(choice)) {
  if (joints_.empty()) fail("[[joints]]", "there is no joint", "a structure without joints is linear: `couple` gives its FRFs");
  if (at(joints_.size()) != structure_->joints()) fail("[[joints]]", "the structure has another number of joints", "");
  if (force_.amplitudes.cols() != structure_->forces() || force_.amplitudes.rows() != at(force_.harmonics.size())) {
    fail("[force]", "the force has other places or harmonics than the structure was asked for", "");
  }
  if (!force_.amplitudes.allFinite()) fail("[force]", "an amplitude is not finite", "");
}

HarmonicBalance HarmonicBalance::with_joint(std::size_t index, Joint joint) const {
  HarmonicBalance other = *this;
  other.joints_.at(index) = std::move(joint);
  return other;
}

std::vector<int> HarmonicBalance::covered(std::vector<int> numbers, double omega) const {
  std::erase_if(numbers, [&](int n) { return !structure_->covers(n * omega); });
  return numbers;
}

std::vector<int> HarmonicBalance::following(const Harmonics& harmonics) const {
  const bool odd = is_odd(force_.harmonics) && harmonics.only_odd();
  std::vector<int> next;
  for (int n = harmonics.largest() + 1; at(next.size()) < looked_ahead * (odd ? 1 : 2); ++n) {
    if (!odd || n % 2 == 1) next.push_back(n);
  }
  return next;
}

HarmonicSolution HarmonicBalance::describe(const CondensedEquations& equations, const HarmonicLine& line, double level,
                                           const Eigen::VectorXd& motion) const {
  return described(equations, line, level, motion, equations.forces(line.omega, motion));
}

HarmonicSolution described(const CondensedEquations& equations, const HarmonicLine& line, double level, const Eigen::VectorXd& motion,
                           Eigen::MatrixXcd force) {
  HarmonicSolution solution;
  solution.omega = line.omega;
  solution.level = level;
  solution.harmonics = equations.harmonics().numbers();
  solution.joint_motion = equations.amplitudes(motion);
  solution.joint_force = std::move(force);
  solution.response.resize(solution.joint_force.rows(), line.harmonics.front().free.size());
  solution.loss = Eigen::VectorXd::Zero(solution.joint_force.cols());
  for (Eigen::Index n = 0; n < solution.response.rows(); ++n) {
    const HarmonicLine::One& one = line.harmonics[static_cast<std::size_t>(n)];
    solution.response.row(n) = (level * one.free - one.to_joints * solution.joint_force.row(n).transpose()).transpose();
    const Eigen::ArrayXcd power = solution.joint_force.row(n).array() * solution.joint_motion.row(n).array().conjugate();
    solution.loss.array() += std::numbers::pi * equations.harmonics()[n] * power.imag();
  }
  return solution;
}

/// What the next harmonics of the joints' forces would move: those that the structure covers, and those that it does not.
void HarmonicBalance::look_ahead(const CondensedEquations& equations, const Eigen::VectorXd& motion,
                                 HarmonicSolution& solution) const {
  const Harmonics next(following(equations.harmonics()));
  const Eigen::MatrixXcd force = equations.forces(solution.omega, motion, next);
  const double size = solution.joint_motion.norm();
  for (Eigen::Index i = 0; i < next.size(); ++i) {
    const double omega = next[i] * solution.omega;
    if (!structure_->covers(omega)) continue;
    const Eigen::MatrixXcd g = structure_->at(omega).topLeftCorner(force.cols(), force.cols());
    solution.next = std::max(solution.next, (g * force.row(i).transpose()).norm() / std::max(size, 1e-300));
  }
  std::vector<int> wanted = choice_.fixed.empty() ? next.numbers() : choice_.fixed;
  std::erase_if(wanted, [&](int n) { return structure_->covers(n * solution.omega); });
  if (wanted.empty() || wanted.back() == 0) return;
  const Harmonics dropped(wanted);
  const Eigen::MatrixXcd missing = equations.forces(solution.omega, motion, dropped);
  for (Eigen::Index i = 0; i < dropped.size(); ++i) {
    const Eigen::MatrixXcd g = structure_->at(structure_->nearest(dropped[i] * solution.omega));
    const Eigen::VectorXcd f = missing.row(i).transpose();
    solution.dropped.push_back(
        {dropped[i], f.cwiseAbs().maxCoeff(), (g.topLeftCorner(f.size(), f.size()) * f).cwiseAbs().maxCoeff()});
  }
}

HarmonicSolution HarmonicBalance::solve_for(const Harmonics& harmonics, double omega, double level,
                                            const HarmonicSolution* neighbour) const {
  const CondensedEquations equations(joints_, harmonics);
  const HarmonicLine line = harmonic_line(*structure_, harmonics, force_, omega);
  const Attempt attempt = attempt_all(equations, line, level, neighbour);
  HarmonicSolution solution = describe(equations, line, level, attempt.result.motion);
  solution.converged = attempt.result.converged;
  solution.residual = attempt.result.residual;
  solution.start = attempt.start;
  solution.steps = attempt.steps;
  if (solution.converged) look_ahead(equations, attempt.result.motion, solution);
  return solution;
}

HarmonicSolution HarmonicBalance::solve(double omega, double level, const HarmonicSolution* neighbour) const {
  if (!(omega > 0.0))
    fail("[frequency]", std::to_string(omega) + " rad/s is no frequency of a periodic force", "frequencies are above 0");
  if (!structure_->covers(omega)) {
    fail("[frequency]", "the structure's FRFs have no line at " + std::to_string(hertz(omega)) + " Hz",
         "choose among the lines of the files");
  }
  if (!choice_.fixed.empty()) return solve_for(Harmonics(covered(choice_.fixed, omega)), omega, level, neighbour);

  const std::vector<int> all = covered(needed_harmonics(force_, choice_.largest).numbers(), omega);
  int largest = neighbour != nullptr && neighbour->converged ? neighbour->harmonics.back() : force_.harmonics.back();
  HarmonicSolution solution;
  int steps = 0;
  for (;; largest = solution.harmonics.back() + 1) {
    std::vector<int> numbers;
    for (const int n : all) {
      if (n <= largest || numbers.empty() || numbers.back() < std::max(1, largest))
        numbers.push_back(n);
    }
    solution = solve_for(Harmonics(numbers), omega, level, solution.converged ? &solution : neighbour);
    steps += solution.steps;
    if (!solution.converged || solution.next <= choice_.tolerance || numbers.size() == all.size()) break;
  }
  solution.steps = steps;
  return solution;
}

}  // namespace jointid::response

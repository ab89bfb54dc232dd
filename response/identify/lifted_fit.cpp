#include "response/identify/lifted_fit.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "base/control.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "minimise/damping.hpp"
#include "response/identify/corrected_models.hpp"
#include "response/identify/direct_step.hpp"
#include "response/identify/lifted_line.hpp"
#include "response/identify/response_residuals.hpp"

namespace jointid::response {
namespace {

constexpr double tolerances[] = {0.3, 0.1, 0.03, 0.01};   ///< of the joint's force
constexpr double all_tolerances[] = {0.03, 0.01};         ///< of all lines, where some told the numbers
constexpr double last_tolerances[] = {0.01, 1e-3, 1e-4};  ///< from another fit
constexpr int most_lifted_steps = 30;                                ///< with one tolerance
constexpr double least_gain = 1e-3, least_share_gained = 3e-3;  ///< of Σr², and of it relatively: a step that lowers it by less
constexpr minimise::DampingRange lifted_damping = {.least = 0.0, .most = 1e6, .again = 1e-9};
constexpr double shares[] = {1.0, 0.5, 0.2};  ///< of a step that are tried before more damping

/// All unknowns.
struct Point {
  Eigen::VectorXd numbers;
  std::vector<Eigen::MatrixXcd> force;
  LineErrors errors;
};

class LiftedProblem {
 public:
  LiftedProblem(const std::shared_ptr<const Receptance>& structure, const std::vector<MeasuredState>& states,
                const LawUnknowns& unknowns, const std::vector<int>& harmonics, const FitWork& work)
      : structure_(structure),
        states_(states),
        unknowns_(unknowns),
        harmonics_(harmonics),
        work_(work),
        layout_(ResponseResiduals(structure, states, unknowns, harmonics).models(), *structure),
        tolerance_(states.size(), Eigen::VectorXd::Zero(structure->joints())) {
    for (const StateModel& model : models(layout_.no_errors())) harmonics_of_.push_back(model.harmonics());
  }

  /// Forces of the direct step, and those of the law with these numbers at its motions where it has none.
  std::optional<Point> start(const Eigen::VectorXd& numbers) {
    Point point = {numbers, {}, layout_.no_errors()};
    const auto joints = unknowns_.at_numbers(numbers);
    if (!joints) return std::nullopt;
    try {
      for (const MeasuredState& state : states_) {
        const DirectStep step = direct_step(*structure_, state);
        add_state(*joints, step.harmonics, step.joint_motion, step.joint_force, point);
      }
    } catch (const InputError&) {
      return std::nullopt;
    }
    return point;
  }

  std::optional<Point> start(const LiftedFit& from) {
    return start({from.numbers, {}, carried(from.layout, from.errors, layout_)}, from.states);
  }

  /// Where harmonic balance has the states of these numbers, with the receptances as measured.
  std::optional<Point> start_in_balance(const Eigen::VectorXd& numbers) {
    const auto value = ResponseResiduals(models(layout_.no_errors()), unknowns_, work_).evaluate(numbers);
    return value ? start({numbers, {}, layout_.no_errors()}, value->states) : std::nullopt;
  }

  void set_tolerance(double share) {
    for (std::size_t i = 0; i < states_.size(); ++i) tolerance_[i] = share * scale_[i];
  }

  std::optional<double> cost(const Point& point) const {
    stop_if(work_.interrupted);
    const auto joints = unknowns_.at_numbers(point.numbers);
    if (!joints) return std::nullopt;
    const std::vector<StateModel> models = this->models(point.errors);
    const std::vector<JointForce> forces = joint_forces(*joints);
    std::vector<double> squares(models.size());
    for_each_index(models.size(), work_.threads, [&](std::size_t i) {
      squares[i] = LiftedState(models[i], forces, point.force[i], tolerance_[i], false).residual().squaredNorm();
    });
    double sum = squared_norm(point.errors) + prior_residuals(unknowns_, point.numbers).residual.squaredNorm();
    for (const double each : squares) sum += each;
    return std::isfinite(sum) ? std::optional(sum) : std::nullopt;
  }

  /// Moves the point to a minimum with the present tolerance; how many steps.
  int descend(Point& point) const {
    double now = cost(point).value_or(0.0);
    minimise::Damping damping(lifted_damping);
    int steps = 0;
    LiftedLines lines(layout_, unknowns_, work_.threads);
    for (; steps < most_lifted_steps; ++steps) {
      lines.set(models(point.errors), point.numbers, point.force, point.errors, tolerance_);
      const double gain = now - lines.least(minimise::damped_step(lines.reduced(), 0.0));
      if (!(gain > least_gain + least_share_gained * now)) break;
      if (!move(lines, point, now, damping)) break;
    }
    return steps;
  }

  LiftedFit described(Point point, int steps) const {
    LiftedFit out = {point.numbers, layout_, point.errors, {}, 0.0, steps};
    const std::vector<StateModel> models = this->models(point.errors);
    const std::vector<JointForce> joints = joint_forces(*unknowns_.at_numbers(point.numbers));
    out.chi_square = squared_norm(point.errors);
    for (std::size_t i = 0; i < models.size(); ++i) {
      HarmonicSolution solution;
      solution.converged = true;
      solution.harmonics = models[i].harmonics().numbers();
      solution.joint_motion = LiftedState::motion(models[i], point.force[i]);
      solution.joint_force = point.force[i];
      out.states.push_back({std::move(solution), {}, {}});
      const Eigen::Index measured = measured_numbers(states_[i]);
      out.chi_square += LiftedState(models[i], joints, point.force[i], tolerance_[i], false).residual().head(measured).squaredNorm();
    }
    return out;
  }

 private:
  std::optional<Point> start(Point point, const std::vector<StatePrediction>& states) {
    const auto joints = unknowns_.at_numbers(point.numbers);
    if (!joints) return std::nullopt;
    for (const StatePrediction& state : states)
      add_state(*joints, state.solution.harmonics, state.solution.joint_motion, state.solution.joint_force, point);
    return point;
  }

  /// Its forces are those known at some harmonics and the law's at all others; the law's tell the scale.
  void add_state(const std::vector<Joint>& joints, const std::vector<int>& known, const Eigen::MatrixXcd& motion,
                 const Eigen::MatrixXcd& force, Point& point) {
    const std::size_t i = point.force.size();
    const Harmonics& harmonics = harmonics_of_[i];
    Eigen::MatrixXcd all = Eigen::MatrixXcd::Zero(harmonics.size(), structure_->joints());
    const auto put = [&](const Eigen::MatrixXcd& values) {
      for (std::size_t n = 0; n < known.size(); ++n) {
        const Eigen::Index row = harmonics.find(known[n]);
        if (row >= 0) all.row(row) = values.row(at(n));
      }
    };
    put(motion);
    const CondensedEquations equations(joints, harmonics);
    all = equations.forces(states_[i].omega, equations.pack(all));
    scale_.emplace_back(all.cwiseAbs().colwise().maxCoeff().transpose());
    put(force);
    point.force.push_back(std::move(all));
  }

  std::vector<StateModel> models(const LineErrors& errors) const {
    return corrected_models(structure_, states_, layout_, errors, harmonics_);
  }

  bool move(const LiftedLines& lines, Point& point, double& now, minimise::Damping& damping) const {
    return damping.search([&](double value) {
      const Eigen::VectorXd step = minimise::damped_step(lines.reduced(), value);
      const LiftedChange change = lines.change(step);
      for (const double share : shares) {
        Point tried = point;
        tried.numbers += share * step;
        for (std::size_t i = 0; i < tried.force.size(); ++i) tried.force[i] += share * change.force[i];
        for (std::size_t i = 0; i < tried.errors.size(); ++i) tried.errors[i] += share * change.errors[i];
        const auto next = cost(tried);
        if (!next || !(*next < now)) continue;
        point = std::move(tried);
        now = *next;
        if (share == 1.0) damping.less();
        return true;
      }
      return false;
    });
  }

  const std::shared_ptr<const Receptance>& structure_;
  const std::vector<MeasuredState>& states_;
  const LawUnknowns& unknowns_;
  const std::vector<int>& harmonics_;
  const FitWork& work_;
  LineLayout layout_;
  std::vector<Harmonics> harmonics_of_{};             ///< of each state
  std::vector<Eigen::VectorXd> scale_{}, tolerance_;  ///< N, of each joint of each state
};

std::optional<LiftedFit> fit(LiftedProblem& problem, std::optional<Point> point, std::span<const double> tolerance) {
  if (!point) return std::nullopt;
  int steps = 0;
  for (const double share : tolerance) {
    problem.set_tolerance(share);
    if (!problem.cost(*point)) return std::nullopt;
    steps += problem.descend(*point);
  }
  return problem.described(std::move(*point), steps);
}

}  // namespace

std::optional<LiftedFit> fit_lifted(const std::shared_ptr<const Receptance>& structure, const std::vector<MeasuredState>& states,
                                    const LawUnknowns& unknowns, const std::vector<int>& harmonics, const FitWork& work) {
  const std::vector<MeasuredState> some = some_lines(states, lines_for_a_start);
  LiftedProblem problem(structure, states, unknowns, harmonics, work);
  if (!some.empty()) {
    LiftedProblem few(structure, some, unknowns, harmonics, work);
    const auto found = fit(few, few.start(unknowns.start()), tolerances);
    if (found) {
      const auto near = problem.start_in_balance(found->numbers);
      return fit(problem, near ? near : problem.start(found->numbers), all_tolerances);
    }
  }
  return fit(problem, problem.start(unknowns.start()), tolerances);
}

std::optional<LiftedFit> fit_lifted(const std::shared_ptr<const Receptance>& structure, const std::vector<MeasuredState>& states,
                                    const LawUnknowns& unknowns, const std::vector<int>& harmonics, const LiftedFit& from,
                                    const FitWork& work) {
  LiftedProblem problem(structure, states, unknowns, harmonics, work);
  return fit(problem, problem.start(from), last_tolerances);
}

}  // namespace jointid::response

#include "response/comparison/compare_iterations.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "base/stopwatch.hpp"
#include "response/harmonic/attempts.hpp"
#include "response/iteration/increments.hpp"
#include "response/iteration/one_joint.hpp"
#include "response/iteration/scheme.hpp"
#include "response/structure/matrix_receptance.hpp"

namespace jointid::response {
namespace {

using Eigen::VectorXd;

struct NamedStart {
  std::string name;
  VectorXd motion;
};

/// The ways of one set of equations.
class Iterations {
 public:
  Iterations(CondensedEquations equations, HarmonicLine line, double level, int lowest, const IterationsAsked& asked)
      : equations_(std::move(equations)), line_(std::move(line)), level_(level), lowest_(lowest), asked_(asked) {}

  std::vector<NamedStart> plain_starts() const {
    return {{"stuck", equations_.stuck(line_, level_)}, {"free", equations_.free(line_, level_)}};
  }
  NamedStart from_fewer(const std::vector<int>& harmonics, const Eigen::MatrixXcd& amplitudes) const {
    return {"one harmonic", embedded(equations_, harmonics, amplitudes)};
  }

  void newton(const NamedStart& start) {
    add("Newton–Raphson", start.name, [&](IterationResult& result) {
      const NewtonRaphson run = newton_raphson(equations_, line_, level_, start.motion);
      result.state = run.converged ? "converged" : "limit";
      result.steps = run.steps;
      return run.motion;
    });
  }

  void scheme(Scheme scheme, bool search, const NamedStart& start) {
    if (!defined(scheme, equations_)) return;
    const bool searched = search || scheme == Scheme::direct;
    IterationResult& added =
        add(std::string(word(scheme)) + (searched ? "" : " without search"), start.name, [&](IterationResult& result) {
          Iteration run =
              iterate(scheme, equations_, line_, level_, start.motion, {.most_steps = asked_.most_steps, .search = search});
          result.state = std::string(word(run.state));
          result.steps = run.steps;
          result.searches = run.searches;
          return run.motion;
        });
    if (added.converged()) added.factor = convergence_factor(scheme, equations_, line_, last_);
  }

  void bracketed() {
    if (!one_joint(equations_, line_, level_).applies) return;
    add("one joint, bracketed", "", [&](IterationResult& result) {
      const OneJointSolution found = one_joint(equations_, line_, level_);
      result.state = "converged";
      result.steps = found.evaluations;
      return found.motion;
    });
  }

  void along(Increment increment, Estimate estimate, int count) {
    const std::string way =
        std::string(word(increment)) + ", " + std::string(word(estimate)) + ", " + std::to_string(count) + " steps";
    add(way, "", [&](IterationResult& result) {
      const IncrementRun run = increments(increment, estimate, count, equations_, line_, level_);
      result.state = run.converged ? "converged" : "failed";
      result.steps = run.steps;
      result.reached = run.reached;
      return run.motion;
    });
  }

  /// Factors at a solution of another way, for ways that converged from no start.
  void complete_factors(const VectorXd& solution) {
    for (IterationResult& result : results_) {
      if (result.factor) continue;
      for (const Scheme each : {Scheme::direct, Scheme::equivalent, Scheme::local, Scheme::wirtinger}) {
        if (defined(each, equations_) && (result.way == word(each) || result.way == std::string(word(each)) + " without search"))
          result.factor = convergence_factor(each, equations_, line_, solution);
      }
    }
  }

  std::vector<IterationResult> results() && { return std::move(results_); }
  const CondensedEquations& equations() const { return equations_; }

  /// The solution of the first way that converged; none where none did.
  const VectorXd& solution() const { return solution_; }

 private:
  template <class Work>
  IterationResult& add(const std::string& way, const std::string& start, const Work& work) {
    if (asked_.begin) asked_.begin(start.empty() ? way : way + ", " + start);
    IterationResult& result = results_.emplace_back();
    result.way = way;
    result.start = start;
    result.largest_harmonic = equations_.harmonics().largest();
    const auto begin = Clock::now();
    last_ = work(result);
    result.seconds = seconds_since(begin);
    if (!result.converged()) return result;
    if (solution_.size() == 0) solution_ = last_;
    result.joint_motion = equations_.amplitudes(last_);
    if (asked_.exact) result.of_amplitude = std::abs(amplitude() - *asked_.exact) / std::abs(*asked_.exact);
    return result;
  }

  /// X of the lowest harmonic.
  Complex amplitude() const {
    const Eigen::Index n = equations_.harmonics().find(lowest_);
    const HarmonicLine::One& one = line_.harmonics[static_cast<std::size_t>(n)];
    const Eigen::VectorXcd force = equations_.forces(line_.omega, last_).row(n).transpose();
    return level_ * one.free(0) - (one.to_joints.row(0) * force)(0);
  }

  CondensedEquations equations_;
  HarmonicLine line_;
  double level_;
  int lowest_;
  const IterationsAsked& asked_;
  VectorXd last_, solution_;
  std::vector<IterationResult> results_;
};

void run_first(Iterations& one, const IterationsAsked& asked) {
  one.bracketed();
  for (const NamedStart& start : one.plain_starts()) {
    one.newton(start);
    one.scheme(Scheme::direct, false, start);
    for (const Scheme each : {Scheme::equivalent, Scheme::local, Scheme::wirtinger}) {
      one.scheme(each, true, start);
      one.scheme(each, false, start);
    }
  }
  for (const int count : asked.increments) {
    for (const Increment increment : {Increment::force, Increment::joint}) {
      for (const Estimate estimate : {Estimate::direct, Estimate::linear, Estimate::quadratic, Estimate::best})
        one.along(increment, estimate, count);
    }
  }
}

void run_more(Iterations& more, std::vector<NamedStart> starts) {
  for (const NamedStart& start : starts) {
    more.newton(start);
    more.scheme(Scheme::direct, false, start);
    for (const Scheme each : {Scheme::local, Scheme::wirtinger}) {
      more.scheme(each, true, start);
      more.scheme(each, false, start);
    }
  }
}

}  // namespace

std::vector<IterationResult> compare_iterations(const MatrixAssembly& assembly, const Excitation& force, double omega,
                                                double level, const VectorXd& response, const IterationsAsked& asked) {
  const MatrixReceptance receptance(assembly.structure, assembly.w, response, assembly.forces);
  const int lowest = *std::ranges::find_if(force.harmonics, [](int n) { return n > 0; });
  const auto ways_of = [&](int largest) {
    const Harmonics harmonics = needed_harmonics(force, std::max(largest, force.harmonics.back()));
    return Iterations(CondensedEquations(assembly.joints, harmonics), harmonic_line(receptance, harmonics, force, omega), level,
                      lowest, asked);
  };
  Iterations one = ways_of(force.harmonics.back());
  run_first(one, asked);
  if (one.solution().size() > 0) one.complete_factors(one.solution());

  Iterations more = ways_of(asked.largest_harmonic);
  const std::vector<int> few = one.equations().harmonics().numbers();
  if (more.equations().harmonics().numbers() == few) return std::move(one).results();
  std::vector<NamedStart> starts = more.plain_starts();
  if (one.solution().size() > 0) starts.insert(starts.begin(), more.from_fewer(few, one.equations().amplitudes(one.solution())));
  run_more(more, std::move(starts));
  if (more.solution().size() > 0) more.complete_factors(more.solution());
  std::vector<IterationResult> all = std::move(one).results();
  for (IterationResult& result : std::move(more).results()) all.push_back(std::move(result));
  return all;
}

}  // namespace jointid::response

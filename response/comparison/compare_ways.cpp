#include "response/comparison/compare_ways.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/stopwatch.hpp"
#include "response/harmonic/harmonic_balance.hpp"
#include "response/orbit/orbit_figures.hpp"
#include "response/structure/matrix_receptance.hpp"
#include "response/time/algorithm_one.hpp"
#include "response/time/algorithm_two.hpp"

namespace jointid::response {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Index compared = 100;    ///< times of a period
constexpr int synthesised = 4000;  ///< times of a period at which harmonics are summed for their largest |x|

/// What the others are compared with.
struct Reference {
  VectorXd motion;  ///< at i T/100
  Complex amplitude;
  double largest = 0.0;
};

/// Re Σ X_n e^{inθ} at `count` even times.
VectorXd summed(const HarmonicSolution& solution, int count) {
  VectorXd x = VectorXd::Zero(count);
  for (Index i = 0; i < count; ++i) {
    const double theta = 2.0 * std::numbers::pi * static_cast<double>(i) / count;
    for (std::size_t n = 0; n < solution.harmonics.size(); ++n) {
      x[i] += std::real(solution.response(at(n), 0) * std::polar(1.0, solution.harmonics[n] * theta));
    }
  }
  return x;
}

/// X_n of even samples of a period.
Complex amplitude_of(const VectorXd& period, int harmonic) {
  Complex sum = 0.0;
  for (Index i = 0; i < period.size(); ++i) {
    sum += period[i] *
           std::polar(1.0, -2.0 * std::numbers::pi * harmonic * static_cast<double>(i) / static_cast<double>(period.size()));
  }
  return 2.0 / static_cast<double>(period.size()) * sum;
}

class Comparison {
 public:
  Comparison(const MatrixAssembly& assembly, const Excitation& force, double omega, double level, const VectorXd& response,
             const WaysAsked& asked)
      : assembly_(assembly),
        force_(force),
        omega_(omega),
        level_(level),
        response_(response),
        asked_(asked),
        problem_(periodic_problem(assembly, force, omega, level)) {
    harmonic_ = *std::ranges::find_if(force.harmonics, [](int n) { return n > 0; });
  }

  std::vector<WayResult> run() {
    exact();
    if (!ways_.front().found) return ways_;
    for (const int largest : asked_.largest_harmonics) balance(largest);
    for (const int steps : asked_.steps_per_period) {
      march<AlgorithmOne>("Algorithm One", steps, [](const AlgorithmOne& one) { return static_cast<int>(one.solutions()); });
    }
    for (const int steps : asked_.steps_per_period)
      march<AlgorithmTwo>("Algorithm Two", steps, [](const AlgorithmTwo&) { return 0; });
    return ways_;
  }

 private:
  /// Times `work`, which fills a result.
  template <class Work>
  WayResult& add(const std::string& way, const Work& work) {
    if (asked_.begin) asked_.begin(way);
    WayResult& result = ways_.emplace_back();
    result.way = way;
    const auto start = Clock::now();
    work(result);
    result.seconds = seconds_since(start);
    return result;
  }

  void judge(WayResult& result, const VectorXd& motion, Complex amplitude, double largest) const {
    result.largest = largest;
    result.amplitude = amplitude;
    result.of_largest = largest / reference_.largest - 1.0;
    result.of_amplitude = std::abs(amplitude - reference_.amplitude) / std::abs(reference_.amplitude);
    const VectorXd off = motion - reference_.motion;
    result.of_motion = (off.array() - off.mean()).abs().maxCoeff() / reference_.largest;
  }

  void exact() {
    PeriodicOrbit orbit;
    WayResult& result = add("exact", [&](WayResult& out) {
      orbit = find_orbit(problem_);
      out.found = orbit.closed;
      out.periods = orbit.periods;
      out.steps = orbit.newton_steps;
    });
    if (!result.found) return;
    result.residual_force_free = std::ranges::find(orbit.residual_force_free, true) != orbit.residual_force_free.end();
    // The response as a coordinate of its own has a largest value too: marched at the compared times, refined by its harmonics.
    const OrbitFigures found = figures(problem_, orbit, {harmonic_});
    reference_.amplitude = (response_.transpose() * found.x)(0);
    reference_.motion.resize(compared);
    ExactMarch march(problem_.structure, problem_.force());
    for (std::size_t j = 0; j < orbit.joints.size(); ++j) march.joint_states()[j] = orbit.joints[j]->clone();
    march.place(0.0, orbit.x, orbit.v, orbit.f);
    for (Index i = 0; i < compared; ++i) {
      march.march(problem_.period() * static_cast<double>(i) / compared);
      reference_.motion[i] = response_.dot(march.motion().x);
    }
    Index coordinate = 0;
    const bool single = response_.cwiseAbs().maxCoeff(&coordinate) == 1.0 && response_.cwiseAbs().sum() == 1.0;
    reference_.largest = single ? found.largest[coordinate] : reference_.motion.cwiseAbs().maxCoeff();
    result.largest = reference_.largest;
    result.amplitude = reference_.amplitude;
    result.of_largest = result.of_amplitude = result.of_motion = orbit.closure;
  }

  void balance(int largest) {
    HarmonicSolution solution;
    WayResult& result = add("harmonics to " + std::to_string(largest), [&](WayResult& out) {
      const auto receptance = std::make_shared<MatrixReceptance>(assembly_.structure, assembly_.w, response_, assembly_.forces);
      std::vector<int> numbers = needed_harmonics(force_, std::max(largest, force_.harmonics.back())).numbers();
      const HarmonicBalance balance(receptance, assembly_.joints, force_, {.fixed = std::move(numbers)});
      solution = balance.solve(omega_, level_);
      out.found = solution.converged;
      out.steps = solution.steps;
    });
    if (!result.found) return;
    const auto place = std::ranges::find(solution.harmonics, harmonic_) - solution.harmonics.begin();
    judge(result, summed(solution, compared), solution.response(place, 0), summed(solution, synthesised).cwiseAbs().maxCoeff());
  }

  template <class Algorithm, class Solutions>
  void march(const std::string& name, int steps, const Solutions& solutions) {
    VectorXd period = VectorXd::Zero(steps);
    WayResult& result = add(name + ", T/" + std::to_string(steps), [&](WayResult& out) {
      Algorithm algorithm(problem_.structure, problem_.force(), problem_.period() / steps);
      out.found = settle(algorithm, period, out.periods);
      out.steps = solutions(algorithm);
    });
    if (!result.found) return;
    VectorXd motion(compared);
    for (Index i = 0; i < compared; ++i) motion[i] = period[i * steps / compared];
    judge(result, motion, amplitude_of(period, harmonic_), period.cwiseAbs().maxCoeff());
  }

  /// Periods from rest until two of them differ little enough; x at the beginnings of the last one's steps.
  template <class Algorithm>
  bool settle(Algorithm& algorithm, VectorXd& period, double& periods) const {
    double before = 0.0;
    for (int count = 1; count <= asked_.most_periods; ++count) {
      VectorXd next(period.size());
      for (double& x : next) {
        x = response_.dot(algorithm.motion().x);
        algorithm.step();
      }
      const double change = (next - period).norm(), size = next.norm();
      const double ratio = before > 0.0 ? change / before : 1.0;
      before = change;
      period = next;
      periods = count;
      if (!std::isfinite(size)) return false;
      if (change <= asked_.settled * std::max(0.0, 1.0 - ratio) * size) return true;
    }
    return false;
  }

  const MatrixAssembly& assembly_;
  const Excitation& force_;
  double omega_, level_;
  const VectorXd& response_;
  const WaysAsked& asked_;
  PeriodicProblem problem_;
  int harmonic_ = 1;
  Reference reference_;
  std::vector<WayResult> ways_;
};

}  // namespace

std::vector<WayResult> compare_ways(const MatrixAssembly& assembly, const Excitation& force, double omega, double level,
                                    const VectorXd& response, const WaysAsked& asked) {
  return Comparison(assembly, force, omega, level, response, asked).run();
}

}  // namespace jointid::response

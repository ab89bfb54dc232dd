// Time of one fit of friction laws from vibration, of one joint at 12 lines × 3 levels × 3 harmonics and of two joints at 200 lines × 6
// levels × 5 harmonics, with 1 % circular noise on the FRFs of the parts and on the phasors. Promised: 0.2 s, and 40 s of processor time
// on two threads, stiffness and limit within 4.5 deviations of the truth.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/random.hpp"
#include "base/stopwatch.hpp"
#include "bench/bench.hpp"
#include "friction/law/laws.hpp"
#include "problems/vibration/law_problem_cases.hpp"
#include "response/identify/law_choice.hpp"

namespace {

using namespace jointid;

std::vector<double> lines(double from, double to, std::size_t count) {
  std::vector<double> all;
  for (std::size_t i = 0; i < count; ++i)
    all.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(1, count - 1)));
  return all;
}

/// 1 % of circular noise on parts and phasors; of a harmonic that hardly is there a thousandth of the largest counts as its size.
problems::LawStates noisy_states(const problems::LawProblem& problem) {
  constexpr double purity = 1e-3;
  const problems::LawMeasurement exact = problems::measure(problem);
  problems::LawStates data = {problems::states_of(problem, problems::polluted(problem, exact, 1)).structure,
                              problems::states_of(problem, exact).states};
  std::uint64_t entry = 0;
  for (response::MeasuredState& state : data.states) {
    const Eigen::RowVectorXd least = purity * state.response.cwiseAbs().colwise().maxCoeff();
    state.deviation = problem.noise / std::sqrt(2.0) * state.response.cwiseAbs().cwiseMax(least.replicate(state.response.rows(), 1));
    for (Eigen::Index k = 0; k < state.response.size(); ++k) {
      const auto [real, imaginary] = normal_numbers({.seed = 1, .trial = 0, .set = 1}, entry++);
      state.response(k) += state.deviation(k) * Complex(real, imaginary);
    }
  }
  return data;
}

/// Largest error of stiffness and limit in deviations.
double worst_error(const problems::LawProblem& problem, const response::LawFit& fit) {
  double worst = fit.joints.empty() ? jointid::nan : 0.0;
  const auto add = [&](const friction::FittedValue& value, double truth) {
    worst = std::max(worst, value.std_error ? std::abs(value.value - truth) / *value.std_error : 1e9);
  };
  for (std::size_t j = 0; j < fit.joints.size(); ++j) {
    const auto truth = friction::make_element(problem.joints[j].law, problem.joints[j].parameters);
    add(fit.joints[j].stiffness, truth->response(0.0).tangent);
    add(fit.joints[j].limit, truth->limit());
  }
  return worst;
}

void measure_fit(const problems::LawProblem& problem, std::size_t threads, double allowed, bench::Promises& promises) {
  const problems::LawStates data = noisy_states(problem);
  std::vector<std::string> laws;
  std::vector<response::Joint> beside;
  for (const auto& joint : problem.joints) {
    laws.push_back(joint.law);
    beside.push_back({.name = joint.name});
  }
  const Clock::time_point start = Clock::now();
  const double before = bench::processor_seconds();
  response::LawFitOptions options;
  options.work.threads = threads;
  const response::LawFit fit =
      response::fit_from(data.structure, data.states, response::law_starts(*data.structure, data.states, laws, beside), options);
  const double processor = bench::processor_seconds() - before, error = worst_error(problem, fit);
  fmt::print("{} joints, {} lines × {} levels × {} harmonics, {} thread(s): {}, χ² {:.1f} of {}, harmonics to {}, {:.3f} s of processor "
             "time, {:.3f} s by the clock, worst error {:.2f} deviations\n",
             problem.joints.size(), problem.frequency_hz.size(), problem.levels.size(), problem.measured.size(), threads,
             response::word(fit.status), fit.chi_square, fit.freedom, fit.rounds.empty() ? 0 : fit.rounds.back().largest, processor,
             seconds_since(start), error);
  promises.speed_at_most(problem.name + ": processor time, s", processor, allowed);
  promises.at_most(problem.name + ": largest error in deviations", error, 4.5);
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  problems::LawProblem one = problems::make_law_problem("sdof-iwan");
  one.levels = {0.5, 3.0, 12.0};
  one.measured = {1, 3, 5};
  measure_fit(one, 1, 0.2, promises);
  problems::LawProblem two = problems::make_law_problem("frame-laws");
  two.levels = {1.0, 2.0, 4.0, 8.0, 16.0, 30.0};
  two.measured = {1, 3, 5, 7, 9};
  two.frequency_hz = lines(50.0, 62.0,  // no harmonic meets another one's lines
                           line.count(0, 200, 6));
  measure_fit(two, 2, 40.0, promises);
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "[LINES]", measure); }

// The laws of two friction joints from vibration, 1 % circular noise on the FRFs of the parts and on the phasors (problem
// frame-laws), over seeds of the noise. Prints the row of docs/friction-from-vibration.md. Promised: every fit ends where the
// data do not contradict it, stiffness and limit within 4.5 deviations of the truth, 95 % intervals hold it as often as they say.
#include "friction/law/laws.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "bench/bench.hpp"
#include "problems/vibration/law_problem_cases.hpp"
#include "response/identify/law_choice.hpp"

namespace {

using namespace jointid;

/// Errors of stiffness and limit of every joint in deviations of the bound.
std::vector<double> errors_of(const problems::LawProblem& problem, const response::LawFit& fit) {
  std::vector<double> errors;
  const auto add = [&](const friction::FittedValue& value, double truth) {
    errors.push_back(value.std_error ? std::abs(value.value - truth) / *value.std_error : jointid::nan);
  };
  for (std::size_t j = 0; j < fit.joints.size(); ++j) {
    const auto truth = friction::make_element(problem.joints[j].law, problem.joints[j].parameters);
    add(fit.joints[j].stiffness, truth->response(0.0).tangent);
    add(fit.joints[j].limit, truth->limit());
  }
  return errors;
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  const problems::LawProblem problem = problems::make_law_problem("frame-laws");
  const auto exact = problems::measure(problem);
  std::vector<std::string> laws;
  std::vector<response::Joint> beside;
  for (const auto& joint : problem.joints) {
    laws.push_back(joint.law);
    beside.push_back({.name = joint.name});
  }
  const std::size_t seeds = line.count(0, 20, 2);
  std::vector<double> errors, times;
  double largest = 0.0;
  for (std::size_t seed = 1; seed <= seeds; ++seed) {
    const auto data = problems::states_of(problem, problems::polluted(problem, exact, seed));
    const double before = bench::processor_seconds();
    const response::LawFit fit =
        response::fit_from(data.structure, data.states, response::law_starts(*data.structure, data.states, laws, beside));
    times.push_back(bench::processor_seconds() - before);
    const std::vector<double> own = errors_of(problem, fit);
    errors.insert(errors.end(), own.begin(), own.end());
    largest = std::max(largest, fit.chi_square / chi_square_quantile(static_cast<double>(fit.freedom), 4.0));
    fmt::print("seed {:3}: {}, χ² {:.1f} of {}, {:.2f} s\n", seed, response::word(fit.status), fit.chi_square, fit.freedom,
               times.back());
  }
  double squares = 0.0, worst = 0.0;
  for (const double error : errors) {
    squares += error * error / static_cast<double>(errors.size());
    worst = std::isnan(error) ? jointid::nan : std::max(worst, error);
  }
  const auto held = std::ranges::count_if(errors, [](double error) { return error < normal_95; });
  fmt::print("{} seeds: rms of error over bound {:.3f}, worst {:.2f}, {} of {} intervals hold the truth, median {:.1f} s\n",
             seeds, std::sqrt(squares), worst, held, errors.size(), median(times));
  promises.at_most("largest χ² over its quantile at 4 deviations", largest, 1.0);
  promises.at_most("largest error in deviations", worst, 4.5);
  promises.at_least("share of intervals that hold the truth", static_cast<double>(held) / static_cast<double>(errors.size()),
                    bench::least_share(0.95, errors.size()));
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "[SEEDS]", measure); }

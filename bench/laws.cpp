// Laws of friction joints from vibration over seeds of the noise. Prints the tables of docs/friction-from-vibration.md.
#include <fmt/core.h>

#include <cmath>

#include "bench/bench.hpp"
#include "friction/law/laws.hpp"
#include "problems/vibration/law_problem_cases.hpp"
#include "response/identify/law_choice.hpp"

namespace {

using namespace jointid;

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  problems::LawProblem problem = problems::make_law_problem(line.word(0, "frame-laws"));
  problem.noisy_parts = true;
  problem.noise = std::stod(line.word(3, "0.01"));
  const auto exact = problems::measure(problem);
  std::vector<std::string> laws;
  std::vector<response::Joint> beside;
  for (const auto& joint : problem.joints) { laws.push_back(joint.law); beside.push_back({.name = joint.name}); }
  const std::size_t first = line.count(1, 1, 1), last = line.count(2, 5, 2);
  for (std::size_t seed = first; seed <= last; ++seed) {
    const auto data = problems::states_of(problem, problems::polluted(problem, exact, seed));
    const double before = bench::processor_seconds();
    const auto fit = response::fit_from(data.structure, data.states, response::law_starts(*data.structure, data.states, laws, beside), {});
    fmt::print("{:3} {:20} chi2 {:10.4g} of {} rounds {} steps {} {:.2f} s", seed, response::word(fit.status), fit.chi_square, fit.freedom, fit.rounds.size(), fit.steps,
               bench::processor_seconds() - before);
    for (std::size_t j = 0; j < fit.joints.size(); ++j) {
      const auto& joint = fit.joints[j];
      const auto truth = friction::make_element(problem.joints[j].law, problem.joints[j].parameters);
      fmt::print("  k {:+.2f} F {:+.2f}", (joint.stiffness.value - truth->response(0.0).tangent) / joint.stiffness.std_error.value_or(0.0),
                 (joint.limit.value - truth->limit()) / joint.limit.std_error.value_or(0.0));
    }
    fmt::print("\n");
    std::fflush(stdout);
  }
  promises.holds("x", true);
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "[PROBLEM FIRST LAST NOISE]", measure); }

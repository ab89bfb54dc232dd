// The likelihood of laws against the thesis's two steps (chapter 7.3: equivalent stiffness and damping of the joint over its
// amplitude, then a curve fit of the law to them by (7.20)) on the same data: one joint at four levels of force, laws bilinear,
// Ren, Shoukry, Iwan, and the two joints of problem frame-laws, 1 % circular noise on the FRFs of the parts and on the phasors.
// Prints the table of docs/friction-from-vibration.md. Promised: rms errors of stiffness and limit are at most a third, where the
// table does not say otherwise.
#include "laws/task/two_steps.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "bench/bench.hpp"
#include "friction/law/laws.hpp"
#include "problems/vibration/law_problem_cases.hpp"
#include "response/identify/direct_step.hpp"
#include "response/identify/law_choice.hpp"

namespace {

using namespace jointid;

/// Relative errors of the stiffness and the limit of one joint over the seeds; a seed without an answer counts as wrong
/// altogether.
struct Errors {
  std::vector<double> stiffness, limit;

  void add(double found_stiffness, double found_limit, const friction::Element& truth) {
    stiffness.push_back(found_stiffness / truth.response(0.0).tangent - 1.0);
    limit.push_back(found_limit / truth.limit() - 1.0);
    if (std::isfinite(stiffness.back()) && std::isfinite(limit.back())) return;
    stiffness.pop_back();
    limit.pop_back();
  }
};

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

void compare(const problems::LawProblem& problem, const std::string& title, std::size_t seeds, const std::vector<double>& least,
             bench::Promises& promises) {
  const problems::LawMeasurement exact = problems::measure(problem);
  std::vector<std::string> names;
  std::vector<response::Joint> beside;
  for (const auto& joint : problem.joints) {
    names.push_back(joint.law);
    beside.push_back({.name = joint.name});
  }
  std::vector<Errors> likelihood(names.size()), two_steps(names.size());
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const auto data = problems::states_of(problem, problems::polluted(problem, exact, seed));
    const response::LawFit fit =
        response::fit_from(data.structure, data.states, response::law_starts(*data.structure, data.states, names, beside));
    std::vector<response::DirectStep> steps;
    for (const response::MeasuredState& state : data.states) steps.push_back(response::direct_step(*data.structure, state));
    const std::vector<laws::TwoSteps> curves = laws::two_steps(steps, names);
    for (std::size_t j = 0; j < names.size(); ++j) {
      const auto truth = friction::make_element(problem.joints[j].law, problem.joints[j].parameters);
      if (j < fit.joints.size()) likelihood[j].add(fit.joints[j].stiffness.value, fit.joints[j].limit.value, *truth);
      two_steps[j].add(curves[j].stiffness, curves[j].limit, *truth);
    }
  }
  for (std::size_t j = 0; j < names.size(); ++j) {
    const double stiffness = rms(two_steps[j].stiffness) / rms(likelihood[j].stiffness),
                 limit = rms(two_steps[j].limit) / rms(likelihood[j].limit);
    fmt::print("| {} | {} | {:.2g} | {:.2g} | {:.1f} | {:.2g} | {:.2g} | {:.1f} | {} |\n", title, names[j],
               100.0 * rms(likelihood[j].stiffness), 100.0 * rms(two_steps[j].stiffness), stiffness,
               100.0 * rms(likelihood[j].limit), 100.0 * rms(two_steps[j].limit), limit, seeds - two_steps[j].stiffness.size());
    const std::string what = title + ", " + names[j] + ": error of two steps over that of the likelihood, ";
    promises.at_least(what + "stiffness", stiffness, least[2 * j]);
    promises.at_least(what + "limit", limit, least[2 * j + 1]);
  }
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  const std::size_t seeds = line.count(0, 100, 5);
  fmt::print(
      "| data | law | stiffness, % | two steps, % | ratio | limit, % | two steps, % | ratio | lost "
      "|\n|---|---|---|---|---|---|---|---|---|\n");
  const double least = line.quick() ? 1.0 : 3.0;  // of 5 seeds a ratio is known to a third
  struct One {
    const char* law;
    std::vector<double> parameters;
    std::vector<double> least_ratios;
  };
  const std::vector<One> all = {{"bilinear", {2.5e-5, 4e5}, {least, least}},
                                {"ren", {1e-5, 2.0, 4e5}, {least, least}},
                                {"shoukry", {10.0, 4e4}, {least, least}},
                                {"iwan", {10.0, 4e5, -0.4, 0.5}, {least, least}}};
  for (const One& one : all) {
    problems::LawProblem problem = problems::make_law_problem("sdof-iwan");
    problem.levels = {2.0, 6.0, 15.0, 40.0};
    problem.joints[0].law = one.law;
    problem.joints[0].parameters = one.parameters;
    compare(problem, "one joint", seeds, one.least_ratios, promises);
  }
  compare(problems::make_law_problem("frame-laws"), "frame", seeds, {least, least, least, least}, promises);
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "[SEEDS]", measure); }

// Coverage of 95 % intervals for method "likelihood": of the Cramér–Rao covariance and of a parametric bootstrap by three rules
// (percentile; basic, 2θ̂ − θ*; studentised, θ̂ − t*·σ). Prints the table of docs/likelihood.md and returns 1 when the
// studentised intervals, which [identify] bootstrap gives, cover less than 92 % or more than 97 %.
//   bench_bootstrap [SEEDS [REPLICATES [CASE ...]]]
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "base/statistics.hpp"
#include "ident/algebra/covariance.hpp"
#include "ident/identify.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/findings/bootstrap.hpp"
#include "ident/likelihood/findings/bound_of.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"

namespace {

using namespace jointid;

constexpr std::array names = {"Cramér–Rao", "percentile", "basic", "studentised"};
using Interval = std::array<double, 2>;
using Intervals = std::array<Interval, names.size()>;

Intervals intervals_of(const std::vector<ident::Replicate>& replicates, std::size_t column, double estimate, double error) {
  std::vector<double> values;
  for (const ident::Replicate& replicate : replicates) {
    if (replicate.usable) values.push_back(replicate.theta[column]);
  }
  std::ranges::sort(values);
  const double low = quantile(values, 0.025), high = quantile(values, 0.975);
  return {Interval{estimate - 1.96 * error, estimate + 1.96 * error}, Interval{low, high},
          Interval{2.0 * estimate - high, 2.0 * estimate - low},
          ident::bootstrap_error(replicates, column, estimate, error).ci95};
}

struct Coverage {
  std::array<double, names.size()> covered{}, width{};
  double intervals = 0.0, usable = 0.0, replicates = 0.0, seconds = 0.0;
};

void one_seed(const ident::Scene& scene, const problems::Problem& problem, std::uint64_t seed, Coverage& out) {
  const auto plan = problems::plan(scene, problems::polluted(problem, seed, 0));
  ident::Control control;
  control.detail = ident::Detail::estimates;
  const ident::Solution solution = ident::solve(*plan, control);
  std::vector<double> values;
  for (const ident::Estimate& estimate : solution.unknowns) values.push_back(estimate.value);
  ident::LikelihoodEstimator estimator = ident::make_estimator(*plan, control);
  const ident::LikelihoodFit fit = estimator.refine(ident::scaled(*plan, values), [](std::size_t) {});
  const Eigen::MatrixXd covariance = ident::covariance_of(fit.information);
  plan->scene.identify.bootstrap_seed = seed;
  const auto start = std::chrono::steady_clock::now();
  const std::vector<ident::Replicate> replicates = ident::bootstrap(*plan, estimator, fit, control);
  out.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  out.usable += static_cast<double>(std::ranges::count_if(replicates, &ident::Replicate::usable));
  out.replicates += static_cast<double>(replicates.size());
  for (std::size_t column = 0; column < values.size(); ++column) {
    const auto c = static_cast<Eigen::Index>(column);
    const double truth = problem.unknowns[column].value / plan->unscale(column), error = std::sqrt(covariance(c, c));
    const Intervals all = intervals_of(replicates, column, fit.theta[column], error);
    for (std::size_t kind = 0; kind < names.size(); ++kind) {
      out.covered[kind] += all[kind][0] <= truth && truth <= all[kind][1];
      out.width[kind] += (all[kind][1] - all[kind][0]) / (3.92 * error);
    }
    out.intervals += 1.0;
  }
}

bool run(const std::string& name, std::size_t seeds, std::size_t replicates) {
  const problems::Problem problem = problems::make(name);
  ident::Scene scene = problems::scene(problem);
  scene.identify.method = ident::Method::likelihood;
  scene.identify.equations = {ident::Equation::nn, ident::Equation::nj};
  scene.identify.bootstrap = replicates;
  Coverage out;
  for (std::size_t seed = 1; seed <= seeds; ++seed) one_seed(scene, problem, seed, out);
  fmt::print("| {} |", name);
  for (std::size_t kind = 0; kind < names.size(); ++kind) {
    fmt::print(" {:.3f} ({:.2f}) |", out.covered[kind] / out.intervals, out.width[kind] / out.intervals);
  }
  fmt::print(" {:.1f} % | {:.2g} |\n", 100.0 * out.usable / out.replicates, out.seconds / static_cast<double>(seeds));
  std::fflush(stdout);
  const double studentised = out.covered.back() / out.intervals;
  return studentised >= 0.92 && studentised <= 0.97;
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t seeds = argc > 1 ? std::stoul(argv[1]) : 100, replicates = argc > 2 ? std::stoul(argv[2]) : 200;
  std::vector<std::string> cases(argv + std::min(argc, 3), argv + argc);
  if (cases.empty()) cases = {"C1", "E2"};
  fmt::print("| case, 5 % |");
  for (const char* name : names) fmt::print(" {} (width) |", name);
  fmt::print(" usable | s |\n|---|---|---|---|---|---|---|\n");
  bool good = true;
  for (const std::string& name : cases) good = run(name, seeds, replicates) && good;
  return good ? 0 : 1;
}

// Coverage of 95 % intervals for method "likelihood": of the Cramér–Rao covariance and of a parametric bootstrap by three rules
// (percentile; basic, 2θ̂ − θ*; studentised, θ̂ − t*·σ). Prints the table of docs/likelihood.md. Promised of the
// studentised intervals, which [identify] bootstrap gives: they cover 92 to 97 %.
#include "ident/likelihood/findings/bootstrap.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "base/statistics.hpp"
#include "bench/bench.hpp"
#include "ident/identify.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/findings/bound_of.hpp"
#include "ident/plan/joint_guess.hpp"
#include "minimise/linear/covariance.hpp"
#include "problems/case/catalogue.hpp"
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

std::vector<std::string> problem_names() {
  std::vector<std::string> all;
  for (const problems::ProblemInfo& info : problems::list()) all.push_back(info.name);
  return all;
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
  const ident::LinearisedLikelihood fitted =
      ident::make_estimator(*plan, control).refine(ident::scaled(*plan, values), [](std::size_t) {});
  const ident::LikelihoodFit& fit = fitted.fit;
  const Eigen::MatrixXd covariance = minimise::covariance_of(fit.information);
  plan->scene.identify.bootstrap_seed = seed;
  std::vector<ident::Replicate> replicates;
  out.seconds += bench::seconds([&] { replicates = ident::bootstrap(*plan, fitted, fit, control); });
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

void run(const std::string& name, std::size_t seeds, std::size_t replicates, bool quick, bench::Promises& promises) {
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
  promises.at_least(name + ": usable replicates", out.usable / out.replicates, 0.9);
  promises.at_least(name + ": coverage of studentised intervals", studentised, quick ? bench::least_share(0.92, seeds) : 0.92);
  // Seeds that all cover are no wonder where there are few: width tells too long intervals there.
  if (quick) {
    promises.at_most(name + ": width of studentised intervals over Cramér–Rao", out.width.back() / out.intervals, 1.5);
  } else {
    promises.at_most(name + ": coverage of studentised intervals", studentised, 0.97);
  }
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  const std::size_t seeds = line.count(0, 100, 6), replicates = line.count(1, 200, 20);
  fmt::print("| case, 5 % |");
  for (const char* name : names) fmt::print(" {} (width) |", name);
  fmt::print(" usable | s |\n|---|---|---|---|---|---|---|\n");
  const auto usual = line.quick() ? std::vector<std::string>{"E2"} : std::vector<std::string>{"C1", "E2"};
  const auto cases = line.words() > 2 ? line.choice(2, problem_names(), {}) : usual;
  for (const std::string& name : cases) run(name, seeds, replicates, line.quick(), promises);
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "[SEEDS [REPLICATES [CASE ...]]]", measure); }

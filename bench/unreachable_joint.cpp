// Joints whose coordinates cannot be reached on the assembly (case H4, only H_nn): how many starts lead to the joint, and how far
// off the estimates are with 5 % noise, solver by solver on the same data and starts. Prints the tables of
// docs/unreachable-joints.md. Promised of the two default solvers: 95 of 100 starts reach the joint; and of likelihood that it
// settles in every seed, within 1.1 times the Cramér–Rao bound but for chance; and that without any start it does in 95 of 100 on
// cases H3 and H4. The quick run takes these two solvers, every third line, and of the cases without a start H3.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "ident/identify.hpp"
#include "ident/plan/prediction.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"
#include "tasks/bound.hpp"

namespace {

using namespace jointid;

struct Way {
  std::string label;
  ident::Method method;
  std::string solver;
  bool slow;              ///< a tenth of the starts and seeds
  bool promised = false;  ///< what the documentation promises is promised of it
};

const std::vector<Way> ways = {{"likelihood (default)", ident::Method::likelihood, "gauss-helmert", false, true},
                               {"likelihood, ceres", ident::Method::likelihood, "ceres", true},
                               {"newton (default)", ident::Method::newton, "levenberg-marquardt", false, true},
                               {"newton, thesis", ident::Method::newton, "newton", false},
                               {"newton, ceres", ident::Method::newton, "ceres", false},
                               {"newton, ipopt", ident::Method::newton, "ipopt", false},
                               {"newton, pattern", ident::Method::newton, "pattern", true}};

/// Every third line of a set.
frf::FrfSet thinned(const frf::FrfSet& set) {
  frf::FrfSet out;
  out.header = set.header;
  out.header.frequency_hz.clear();
  for (std::size_t line = 0; line < set.header.lines(); line += 3) {
    out.header.frequency_hz.push_back(set.header.frequency_hz[line]);
    const auto first = set.values.begin() + static_cast<std::ptrdiff_t>(set.index(line, 0, 0));
    out.values.insert(out.values.end(), first, first + static_cast<std::ptrdiff_t>(set.header.entries()));
  }
  return out;
}

/// Mean square over the unknowns of the errors in standard deviations of the bound.
double square_over_bound(const ident::Solution& solution, const std::vector<double>& truth, const std::vector<double>& bound) {
  double squares = 0.0;
  for (std::size_t u = 0; u < truth.size(); ++u) squares += std::pow((solution.unknowns[u].value - truth[u]) / bound[u], 2);
  return squares / static_cast<double>(truth.size());
}

std::vector<double> truth_of(const problems::Problem& problem) {
  std::vector<double> truth;
  for (const problems::ExactUnknown& unknown : problem.unknowns) truth.push_back(unknown.value);
  return truth;
}

class Bench {
 public:
  Bench(bool quick, bench::Promises& promises)
      : problem_(problems::make("H4")),
        base_(problems::scene(problem_)),
        truth_(truth_of(problem_)),
        quick_(quick),
        promises_(promises) {
    if (quick) {
      problem_.assembly = thinned(problem_.assembly);
      for (frf::FrfSet& set : problem_.substructures) set = thinned(set);
    }
  }

  ident::Scene scene(const Way& way) const {
    ident::Scene out = base_;
    out.identify.method = way.method;
    out.identify.solver = ident::parse_solver(way.solver);
    return out;
  }

  /// The largest relative error of an element.
  double error(const ident::Solution& solution) const {
    double largest = 0.0;
    for (std::size_t u = 0; u < truth_.size(); ++u)
      largest = std::max(largest, std::abs(solution.unknowns[u].value / truth_[u] - 1.0));
    return std::isfinite(largest) ? largest : 1e300;
  }

  ident::Solution solve(const ident::Scene& scene, problems::Measurement data) const {
    const auto plan = problems::plan(scene, std::move(data));
    ident::Control control;
    control.threads = 1;
    control.detail = ident::Detail::estimates;
    return ident::solve(*plan, control);
  }

  void starts(const Way& way, std::size_t count) const {
    ident::Scene scene = this->scene(way);
    const problems::Measurement exact = {problem_.substructures, problem_.assembly};
    const ident::Matrix thesis = scene.identify.start.at(restrictions::Kind::stiffness),
                        truth = scene.truth.at(restrictions::Kind::stiffness);
    std::vector<std::string> named;
    double start_error = 0.0;
    for (const auto& [label, from, factor] :
         {std::tuple("thesis", thesis, 1.0), std::tuple("rigid", thesis, 1e3), std::tuple("free", thesis, 1e-5)}) {
      scene.identify.start[restrictions::Kind::stiffness] = scaled(from, [f = factor] { return f; });
      const ident::Solution solution = solve(scene, exact);
      if (named.empty()) start_error = error(solution);
      named.push_back(fmt::format("{}, {}", text(error(solution)), solution.fit.iterations));
    }
    if (way.promised) promises_.at_most(way.label + ": error from the thesis's start", start_error, 1e-8);
    std::mt19937_64 generator(20261121);
    std::uniform_real_distribution<double> change(0.2, 1.8);
    std::size_t reached = 0;
    std::vector<double> iterations, times;
    for (std::size_t k = 0; k < count; ++k) {
      scene.identify.start[restrictions::Kind::stiffness] = scaled(truth, [&] { return change(generator); });
      const ident::Solution solution = solve(scene, exact);
      times.push_back(1e3 * solution.runtime_s.total);
      if (error(solution) > 1e-8) continue;
      ++reached;
      iterations.push_back(static_cast<double>(solution.fit.iterations));
    }
    fmt::print("| {} | {} | {} | {} | {} of {} | {:.0f} | {:.0f} |\n", way.label, named[0], named[1], named[2], reached, count,
               median(iterations), median(times));
    std::fflush(stdout);
    if (!way.promised || count == 0) return;
    promises_.at_least(way.label + ": share of starts that reach the joint",
                       static_cast<double>(reached) / static_cast<double>(count),
                       quick_ ? bench::least_share(0.95, count) : 0.95);
  }

  void noise(const Way& way, std::size_t seeds) const {
    const ident::Scene scene = this->scene(way);
    const auto exact = problems::plan(scene, {problem_.substructures, problem_.assembly});
    ident::Scene bounded = scene;
    bounded.identify.method = ident::Method::likelihood;
    bounded.identify.solver = ident::Solver::automatic;
    const std::vector<double> bound =
        tasks::cramer_rao_bound(*problems::plan(bounded, {problem_.substructures, problem_.assembly}), truth_, ident::Control());
    std::vector<double> errors, decibels, ratios, times;
    std::size_t settled = 0;
    for (std::size_t seed = 1; seed <= seeds; ++seed) {
      const ident::Solution solution = solve(scene, problems::polluted(problem_, seed, 0));
      settled += ident::is_usable(solution.status);
      times.push_back(1e3 * solution.runtime_s.total);
      errors.push_back(error(solution));
      const ident::DecibelError error = ident::predict(*exact, solution.bands, ident::Control());
      decibels.push_back(std::sqrt(error.sum_of_squares / static_cast<double>(error.entries)));
      ratios.push_back(std::sqrt(square_over_bound(solution, truth_, bound)));
    }
    const auto good = std::count_if(errors.begin(), errors.end(), [](double error) { return error <= 0.5; });
    fmt::print("| {} | {} | {} | {} | {} | {:.3g} | {} | {:.0f} |\n", way.label, seeds, settled, good, text(median(errors)),
               median(decibels), text(median(ratios)), median(times));
    std::fflush(stdout);
    if (way.solver != "gauss-helmert" || seeds == 0) return;
    promises_.at_least(way.label + ": seeds converged", static_cast<double>(settled), static_cast<double>(seeds));
    promises_.at_most(way.label + ": median rms error over bound", median(ratios), 1.1 * bench::largest_rms(seeds));
  }

 private:
  static std::string text(double value) { return value > 99.0 ? ">99" : fmt::format("{:.2g}", value); }

  template <class Factor>
  static ident::Matrix scaled(ident::Matrix matrix, Factor factor) {
    for (std::size_t i = 0; i < matrix.size(); ++i) {
      for (std::size_t j = i; j < matrix.size(); ++j) matrix[j][i] = matrix[i][j] *= factor();
    }
    return matrix;
  }

  problems::Problem problem_;
  ident::Scene base_;
  std::vector<double> truth_;
  bool quick_;
  bench::Promises& promises_;
};

/// Method likelihood on a problem without any start and without the assembly's FRFs at the joint.
void without_start(const std::string& name, std::size_t seeds, bool promised, bench::Promises& promises) {
  const problems::Problem problem = problems::make(name);
  ident::Scene scene = problems::scene(problem);
  scene.identify = {};
  scene.identify.method = ident::Method::likelihood;
  const std::vector<double> truth = truth_of(problem);
  const frf::FrfSet exact = problems::without(problem.assembly, problem.joint_dofs);
  const std::vector<double> bound =
      tasks::cramer_rao_bound(*problems::plan(scene, {problem.substructures, exact}), truth, ident::Control());
  std::vector<double> times;
  std::size_t settled = 0, found = 0;
  double squares_of_found = 0.0;
  for (std::size_t seed = 1; seed <= seeds; ++seed) {
    problems::Measurement data = problems::polluted(problem, seed, 0);
    data.assembly = problems::without(data.assembly, problem.joint_dofs);
    const auto plan = problems::plan(scene, std::move(data));
    ident::Control control;
    control.threads = 1;
    const ident::Solution solution = ident::solve(*plan, control);
    times.push_back(solution.runtime_s.total);
    settled += ident::is_usable(solution.status);
    const double square = square_over_bound(solution, truth, bound);
    if (!(std::sqrt(square) < 4.0)) continue;
    ++found;
    squares_of_found += square;
  }
  double largest = 0.0;
  for (std::size_t u = 0; u < truth.size(); ++u) largest = std::max(largest, bound[u] / std::abs(truth[u]));
  fmt::print("| {} | {} | {} | {:.2g} | {} | {} | {} | {:.2f} | {:.2f}, {:.2f} |\n", name, exact.header.lines(), truth.size(),
             largest, seeds, settled, found, std::sqrt(squares_of_found / static_cast<double>(found)), median(times),
             *std::ranges::max_element(times));
  std::fflush(stdout);
  if (promised) {
    promises.at_least(name + " without a start: share that finds the joint",
                      static_cast<double>(found) / static_cast<double>(seeds), bench::least_share(0.95, seeds));
  }
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  const std::size_t seeds = line.count(0, 100, 2), starts = line.count(1, 200, 3);
  std::vector<std::string> solvers;
  for (const Way& way : ways) solvers.push_back(way.solver);
  const auto wanted = line.choice(2, solvers, {"gauss-helmert", "levenberg-marquardt"});
  const Bench bench(line.quick(), promises);
  const auto each = [&](const auto& run) {
    for (const Way& way : ways) {
      if (std::ranges::find(wanted, way.solver) != wanted.end()) run(way);
    }
  };

  fmt::print(
      "| noise-free | thesis's start: largest error, iterations | rigid | free | random starts that reach it | iterations | ms "
      "|\n|---|---|---|---|---|---|---|\n");
  each([&](const Way& way) { bench.starts(way, way.slow ? starts / 10 : starts); });
  fmt::print(
      "\n| 5 % noise | seeds | converged | largest error below 0.5 | its median | assembly FRFs, dB | rms error / bound | ms "
      "|\n|---|---|---|---|---|---|---|---|\n");
  each([&](const Way& way) { bench.noise(way, way.slow ? seeds / 10 : seeds); });
  if (std::ranges::find(wanted, "gauss-helmert") == wanted.end()) return;
  fmt::print(
      "\n| without a start | lines | unknowns | largest bound / value | seeds | converged | joint found | rms error of these / "
      "bound "
      "| s, median and most |\n|---|---|---|---|---|---|---|---|---|\n");
  for (const std::string name : {"H3", "H4", "A1", "C2", "E3", "F1", "F3", "G1"}) {
    const bool promised = name == "H3" || name == "H4";
    if (!line.quick() || name == "H3") without_start(name, seeds, promised, promises);
  }
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "[SEEDS [STARTS [SOLVER ...]]]", measure); }

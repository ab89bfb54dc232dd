// Likelihood by parts over many seeds of a chain of five joints, 1 and 5 % noise, and the full likelihood beside it on some of them:
// cover of the 95 % intervals, rms of the errors over those stated, χ², time. docs/many-joints.md.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "ident/identify.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/case/many_joints_problem.hpp"

namespace {

using namespace jointid;

problems::Problem chain(double level) {
  problems::Problem problem = problems::many_joints_problem(problems::chain_of_beams({.joints = 5, .spacing = 1}), {"chain-5", ""}, false);
  std::get<frf::NoiseModel>(problem.noise).level = level;
  return problem;
}

ident::Scene scene_of(const problems::Problem& problem, ident::Solver solver) {
  ident::Scene scene = problems::scene(problem);
  const frf::NoiseModel& noise = std::get<frf::NoiseModel>(problem.noise);
  scene.noise = ident::NoiseSection{.model = frf::name(noise.kind), .level = noise.level, .frf_model = noise};
  scene.identify.method = ident::Method::likelihood;
  scene.identify.solver = solver;
  return scene;
}

ident::Control quick() {
  ident::Control control;
  control.threads = 1;
  control.detail = ident::Detail::estimates;
  control.judgement = ident::Judgement::none;
  return control;
}

struct Row {
  double covered = 0.0, count = 0.0, ratio = 0.0, seconds = 0.0;
  std::vector<double> squares, stated;  ///< by unknown: Σ error², Σ stated error²
  std::size_t usable = 0;

  double median_rms() const {
    std::vector<double> shares;
    for (std::size_t u = 0; u < squares.size(); ++u) shares.push_back(std::sqrt(squares[u] / stated[u]));
    return median(shares);
  }
};

Row measure(double level, ident::Solver solver, std::size_t seeds) {
  const problems::Problem problem = chain(level);
  const ident::Scene scene = scene_of(problem, solver);
  Row row;
  row.squares.assign(problem.unknowns.size(), 0.0);
  row.stated = row.squares;
  const ident::Control control = quick();
  for (std::size_t seed = 1; seed <= seeds; ++seed) {
    const auto plan = problems::plan(scene, problems::polluted(problem, seed, 0));
    const double before = bench::processor_seconds();
    const ident::Solution found = ident::solve(*plan, control);
    row.seconds += bench::processor_seconds() - before;
    if (!is_usable(found.status) || !found.unknowns.front().std_error) continue;
    ++row.usable;
    row.ratio += found.fit.chi_square->value / found.fit.chi_square->degrees_of_freedom;
    for (std::size_t u = 0; u < problem.unknowns.size(); ++u) {
      const ident::Estimate& estimate = found.unknowns[u];
      const double error = estimate.value - problem.unknowns[u].value;
      row.squares[u] += error * error;
      row.stated[u] += *estimate.std_error * *estimate.std_error;
      row.covered += (*estimate.ci95)[0] <= problem.unknowns[u].value && problem.unknowns[u].value <= (*estimate.ci95)[1];
      row.count += 1.0;
    }
  }
  return row;
}

/// In how many seeds the three loose joints of loose-3 are named first.
void measure_loose(const bench::CommandLine& line, bench::Promises& promises) {
  const std::size_t seeds = line.count(2, 20, 1);
  problems::Problem problem = problems::make_many_joints("loose-3");
  for (const double level : {0.01, 0.05}) {
    std::get<frf::NoiseModel>(problem.noise).level = level;
    ident::Scene scene = scene_of(problem, ident::Solver::automatic);
    std::size_t named = 0;
    double seconds = 0.0, least_sure = 1.0, most_sound = 0.0;
    for (std::size_t seed = 1; seed <= seeds; ++seed) {
      const auto plan = problems::plan(scene, problems::polluted(problem, seed, 0));
      const double before = bench::processor_seconds();
      const ident::Solution found = ident::solve(*plan, quick());
      seconds += bench::processor_seconds() - before;
      std::vector<std::string> first;
      for (std::size_t k = 0; k < 3 && k < found.loose.size(); ++k) first.push_back(found.loose[k].joint);
      std::ranges::sort(first);
      named += first == std::vector<std::string>{"j12", "j27", "j38"};
      if (found.loose.size() < 4) continue;
      least_sure = std::min(least_sure, found.loose[2].probability);
      most_sound = std::max(most_sound, found.loose[3].probability);
    }
    fmt::print("loose-3, {} %: the three first in {} of {} seeds; least probability {:.3g}, largest of another {:.3g}; {:.3g} s\n",
               100.0 * level, named, seeds, least_sure, most_sound, seconds / static_cast<double>(seeds));
    std::fflush(stdout);
    promises.at_least(fmt::format("loose-3, {} %: named first", 100.0 * level), static_cast<double>(named),
                      0.95 * static_cast<double>(seeds));
  }
}

void measure_all(const bench::CommandLine& line, bench::Promises& promises) {
  const std::size_t seeds = line.count(0, 200, 4), beside = line.count(1, 20, 1);
  fmt::print("| noise | solver | seeds | usable | coverage | median rms over stated | χ² over f | s |\n");
  for (const double level : {0.01, 0.05}) {
    for (const ident::Solver solver : {ident::Solver::by_parts, ident::Solver::gauss_helmert}) {
      const bool parts = solver == ident::Solver::by_parts;
      const std::size_t count = parts ? seeds : beside;
      const Row row = measure(level, solver, count);
      const auto usable = static_cast<double>(row.usable);
      const double covered = row.covered / row.count, rms = row.median_rms();
      fmt::print("| {} % | {} | {} | {} | {:.3f} | {:.3f} | {:.3f} | {:.3g} |\n", 100.0 * level, ident::name(solver), count, row.usable,
                 covered, rms, row.ratio / usable, row.seconds / static_cast<double>(count));
      std::fflush(stdout);
      if (!parts) continue;
      const std::string name = fmt::format("{} %", 100.0 * level);
      promises.at_least(name + ": usable", usable / static_cast<double>(count), 1.0);
      promises.at_least(name + ": coverage", covered, line.quick() ? 0.8 : 0.93);
      promises.at_most(name + ": coverage", covered, line.quick() ? 1.0 : 0.97);
      promises.at_most(name + ": median rms over stated", rms, line.quick() ? 2.0 : 1.25);
    }
  }
  measure_loose(line, promises);
}

}  // namespace

int main(int argc, char** argv) {
  return jointid::bench::run(argc, argv, "[SEEDS [SEEDS-OF-THE-FULL-LIKELIHOOD [SEEDS-OF-LOOSE-3]]]", measure_all);
}

// Z of a joint at every line by all ways, and the law fitted to it, over seeds of isolator-zener: error over the Cramér–Rao
// bound, coverage of 95 % intervals, how often AIC picks the law, and run time. Promised: docs/joint-line-by-line.md.
#include <fmt/core.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "base/statistics.hpp"
#include "base/stopwatch.hpp"
#include "bench/bench.hpp"
#include "impedance/identify_lines.hpp"
#include "impedance/scene/read_line_scene.hpp"
#include "problems/lines/line_problem.hpp"

namespace {

using namespace jointid;
using impedance::Way;

impedance::LineScene scene_of(const problems::LineProblem& problem, const std::string& more) {
  return impedance::parse_line_scene(problem.scene + more, problem.name + ".toml");
}

/// What a way makes of all seeds.
struct Tally {
  std::vector<double> errors;  ///< over the bound
  double inside = 0.0, parts = 0.0, seconds = 0.0;
};

void add(const impedance::WayResult& way, const impedance::WayResult& bound, const std::vector<std::vector<Complex>>& truth,
         Tally& to) {
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (!way.lines[i] || way.lines[i]->z.size() != 1) continue;
    const Complex error = way.lines[i]->z(0) - truth[i][0];
    to.errors.push_back(std::abs(error) / std::sqrt(bound.lines[i]->variance(0)));
    to.inside += std::abs(error.real()) < normal_95 * way.lines[i]->re_error(0);
    to.inside += std::abs(error.imag()) < normal_95 * way.lines[i]->im_error(0);
    to.parts += 2.0;
  }
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  const std::size_t seeds = line.count(0, 200, 20);
  const double to_one = std::sqrt(std::numbers::ln2);  // the median of |e| of a circular error of E|e|² = 1
  for (const double level : {0.01, 0.05}) {
    problems::LineProblem exact = problems::make_line_problem("isolator-zener");
    exact.noise = level;
    const std::string noise = fmt::format("\n[noise]\nmodel = \"circular\"\nlevel = {}\n", level);
    const auto bound = impedance::identify_lines(scene_of(exact, noise), exact.substructures, exact.assembly);
    const std::vector<double> theta = {3e4, 9e4, 0.00265, 0.6};
    std::map<Way, Tally> ways;
    double picked = 0.0, inside = 0.0, ok = 0.0;
    for (std::size_t seed = 1; seed <= seeds; ++seed) {
      const problems::LineProblem data = problems::polluted(exact, seed);
      impedance::LineScene scene = scene_of(data, "");
      scene.ways = {Way::likelihood, Way::weighed, Way::average, Way::off_diagonal, Way::relative};
      const Stopwatch watch(ways[Way::likelihood].seconds);
      const auto found = impedance::identify_lines(scene, data.substructures, data.assembly);
      for (const impedance::WayResult& way : found.ways) add(way, bound.likelihood, exact.truth, ways[way.way]);
      ok += found.status == Status::ok;
      picked += found.laws.front().law == impedance::LawKind::fractional_zener;
      for (const impedance::LawFit& law : found.laws) {
        if (law.law != impedance::LawKind::fractional_zener) continue;
        for (std::size_t k = 0; k < theta.size(); ++k) {
          inside += std::abs(law.parameters[k].value - theta[k]) < normal_95 * law.parameters[k].std_error;
        }
      }
    }
    const double count = static_cast<double>(seeds);
    for (const auto& [way, tally] : ways) {
      fmt::print("{:.0f} % {:>12}: median error over bound {:.3f}, coverage {:.3f}\n", 100.0 * level, impedance::name(way),
                 median(tally.errors) / to_one, tally.inside / tally.parts);
    }
    const Tally& best = ways.at(Way::likelihood);
    fmt::print(
        "{:.0f} %: law picked {:.3f}, coverage of its parameters {:.3f}, ok {:.3f}, {:.3f} s a seed of 41 lines with all ways "
        "and laws\n",
        100.0 * level, picked / count, inside / (4.0 * count), ok / count, best.seconds / count);
    const double chance = 4.0 / std::sqrt(best.parts);
    promises.at_most("error over bound", std::abs(median(best.errors) / to_one - 1.0), 0.03 + chance);
    promises.at_most("coverage off 0.95", std::abs(best.inside / best.parts - 0.95), 0.01 + chance);
    if (level < 0.02) promises.at_least("law picked", picked / count, 0.95);
  }
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "[SEEDS]", measure); }

// Joints between virtual points: problem flange (two points, each of sensors and blows all round, noise of 1 %) over seeds. Coverage of
// the 95 % intervals of method "likelihood", errors over standard errors; of flange-turned, whether the sensor that is glued on turned is
// named first and nothing else is said of the straight one. Promised: docs/virtual-points.md.
#include <fmt/core.h>

#include <cmath>

#include "bench/bench.hpp"
#include "ident/check/check.hpp"
#include "ident/identify.hpp"
#include "ident/scene/read_scene.hpp"
#include "problems/problem.hpp"
#include "tests/test_folder.hpp"

namespace {

using namespace jointid;

ident::Scene written(const char* name, std::uint64_t seed, const TestFolder& folder) {
  return ident::read_scene(problems::write(problems::make(name), folder, {.seed = seed, .clean = false}));
}

struct Figures {
  std::size_t inside = 0, count = 0, found = 0, false_alarms = 0;
  double squares = 0.0;  ///< of errors over standard errors
};

void add_joint(const problems::Problem& problem, const ident::Scene& scene, Figures& to) {
  ident::Control control;
  control.threads = 1;
  control.detail = ident::Detail::estimates;
  const ident::Solution solution = ident::solve(*ident::make_plan(scene), control);
  for (std::size_t i = 0; i < solution.unknowns.size(); ++i) {
    const ident::Estimate& unknown = solution.unknowns[i];
    const double truth = problem.unknowns[i].value;
    ++to.count;
    if (!unknown.ci95) continue;
    to.inside += (*unknown.ci95)[0] <= truth && truth <= (*unknown.ci95)[1] ? 1U : 0U;
    to.squares += std::pow((unknown.value - truth) / *unknown.std_error, 2);
  }
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  const std::size_t seeds = line.count(0, 40, 2);
  const problems::Problem problem = problems::make("flange");
  Figures figures;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const TestFolder folder;
    const ident::Scene straight = written("flange", seed, folder);
    add_joint(problem, straight, figures);
    figures.false_alarms += ident::check_scene(straight).verdict == ident::Verdict::clean ? 0U : 1U;
    const ident::CheckResult turned = ident::check_scene(written("flange-turned", seed, folder));
    const bool named = !turned.suspects.empty() && turned.suspects.front().kind == ident::SuspectKind::direction &&
                       turned.suspects.front().dofs.front().name() == "13:+Y";
    figures.found += named ? 1 : 0;
  }
  const double coverage = static_cast<double>(figures.inside) / static_cast<double>(figures.count);
  const double rms = std::sqrt(figures.squares / static_cast<double>(figures.count));
  fmt::print("flange, {} seeds, {} intervals: coverage {:.3f}, rms error over standard error {:.3f}; the turned sensor is named in {}, "
             "straight ones are not clean in {}\n",
             seeds, figures.count, coverage, rms, figures.found, figures.false_alarms);
  promises.at_least("coverage", coverage, bench::least_share(0.92, figures.count));
  promises.at_most("rms error over standard error", rms, 1.1 * bench::largest_rms(figures.count));
  const auto share = [&](std::size_t count) { return static_cast<double>(count) / static_cast<double>(seeds); };
  promises.at_least("seeds in which the turned sensor is named", share(figures.found), bench::least_share(0.95, seeds));
  promises.at_most("seeds in which a straight one is not clean", share(figures.false_alarms), 1.0 - bench::least_share(0.98, seeds));
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "[SEEDS]", measure); }

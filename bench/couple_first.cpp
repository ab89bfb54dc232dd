// Method "likelihood" behind couple_first: case G6, whose parts have 5 % noise before their rotations are coupled: uniform as in the
// thesis, and circular as that of averages is. Coverage of the 95 % intervals and rms errors with what the errors of the coupled FRFs have
// in common, and with their variances alone.
// Promised: docs/coupling.md.
#include <fmt/core.h>

#include <cmath>
#include <string>

#include "bench/bench.hpp"
#include "ident/identify.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/scene/read_scene.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"

namespace {

using namespace jointid;

ident::Scene coupled_scene(const problems::Problem& problem) {
  std::string text = problem.scene;
  const std::string joint = "[joint]\n";
  text.insert(text.find(joint) + joint.size(), "couple_first = [[\"4:+RZ\", \"5:+RZ\"]]\n");
  ident::Scene scene = ident::parse_scene(text, "G6.toml");
  scene.identify.method = ident::Method::likelihood;
  return scene;
}

struct Figures {
  std::size_t inside = 0, count = 0, not_ok = 0;
  double squares = 0.0, chi_square = 0.0;

  double coverage() const { return static_cast<double>(inside) / static_cast<double>(count); }
};

void add(const problems::Problem& problem, const ident::Scene& scene, std::uint64_t seed, bool shared, Figures& to) {
  const auto plan = problems::plan(scene, problems::polluted(problem, seed, 0));
  if (!shared) ident::likelihood_plan(*plan)->observations->forget_error_sums();
  ident::Control control;
  control.threads = 1;
  control.detail = ident::Detail::estimates;
  const ident::Solution solution = ident::solve(*plan, control);
  to.not_ok += solution.status == ident::Status::ok ? 0 : 1;
  to.chi_square += solution.fit.chi_square->value / solution.fit.chi_square->degrees_of_freedom;
  for (std::size_t i = 0; i < solution.unknowns.size(); ++i) {
    const ident::Estimate& unknown = solution.unknowns[i];
    const double truth = problem.unknowns[i].value;  // of the translational spring: the first
    to.inside += unknown.ci95 && (*unknown.ci95)[0] <= truth && truth <= (*unknown.ci95)[1] ? 1U : 0U;
    to.squares += std::pow(unknown.value / truth - 1.0, 2);
    ++to.count;
  }
}

void print(const char* what, const Figures& of, std::size_t tests) {
  fmt::print("  {:22} coverage {:.3f}, rms error {:.5f}, chi²/f {:.3f}, not ok {} of {}\n", what, of.coverage(),
             std::sqrt(of.squares / static_cast<double>(of.count)), of.chi_square / static_cast<double>(tests), of.not_ok, tests);
}

void measure(frf::NoiseKind kind, std::size_t tests, double promised, bench::Promises& promises) {
  problems::Problem problem = problems::make("G6");
  ident::Scene scene = coupled_scene(problem);
  const frf::NoiseModel noise{.kind = kind, .level = 0.05};
  problem.noise = noise;
  scene.noise = ident::NoiseSection{.model = frf::name(kind), .level = noise.level, .frf_model = noise};
  Figures shared, alone;
  for (std::uint64_t seed = 1; seed <= tests; ++seed) {
    add(problem, scene, seed, true, shared);
    add(problem, scene, seed, false, alone);
  }
  fmt::print("G6 with its rotations coupled first, {} noise, {} tests\n", frf::name(kind), tests);
  print("errors in common", shared, tests);
  print("variances alone", alone, tests);
  promises.at_least("coverage with errors in common, " + frf::name(kind), shared.coverage(), bench::least_share(promised, shared.count));
  promises.at_most("rms error with errors in common over that with variances alone", std::sqrt(shared.squares / alone.squares), 1.05);
}

void measure_all(const bench::CommandLine& line, bench::Promises& promises) {
  const std::size_t tests = line.count(0, 200, 10);
  measure(frf::NoiseKind::uniform, tests, 0.92, promises);
  measure(frf::NoiseKind::circular, tests, 0.92, promises);
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "[TESTS]", measure_all); }

// Cost of method "likelihood": cases A1 (5 % noise) and H4 (only H_nn) from scene to result on one core; random modal structures,
// 20 non-joint and 4 joint coordinates, over 100 to 1,000 lines on all cores: time per iteration, exponent in the lines, memory; the
// same beside numpy with dense matrices (bench/peer/likelihood.py), one thread each; and solid blocks on four bolts, 24 joint and 36
// other coordinates, 24 unknowns, to the intervals. Promised: A1 takes at most 100 ms, H4 2 s, 1,000 lines two minutes, the bolts a
// minute with the module blas, time per iteration grows like the lines, numpy takes five times as long and ends within 0.01 standard
// errors, and no estimate is more than 5 of its standard errors off the truth. The quick run takes 100 lines, 30 beside numpy, and 8
// of the bolts.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

#include "bench/bench.hpp"
#include "bench/random_structures.hpp"
#include "dense/blas.hpp"
#include "ident/identify.hpp"
#include "ident/plan/joint_guess.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"
#include "tests/test_folder.hpp"

namespace {

using namespace jointid;

constexpr double level = 0.01;

struct Run {
  std::size_t iterations = 0;
  double seconds = 0.0, processor_seconds = 0.0, largest_error = 0.0;  ///< error in standard errors
};


ident::Scene random_scene() {
  ident::Scene scene;
  restrictions::JointSpec spec;
  spec.dofs = bench::random_joint();
  spec.matrices[restrictions::Kind::stiffness] = restrictions::Pattern::symmetric;
  spec.matrices[restrictions::Kind::hysteretic_damping] = restrictions::Pattern::symmetric;
  scene.joints = {spec};
  scene.identify.method = ident::Method::likelihood;
  return scene;
}

/// Of what was found off `expected`, in standard errors; NaN where there are none.
double largest_error(const ident::Solution& solution, const std::vector<double>& expected) {
  double largest = 0.0;
  for (std::size_t u = 0; u < expected.size(); ++u) {
    const double error = std::abs(solution.unknowns[u].value - expected[u]) / solution.unknowns[u].std_error.value_or(0.0);
    if (!(error <= largest)) largest = error;
  }
  return largest;
}

Run run(ident::Plan& plan, const std::vector<double>& truth, const ident::Control& control) {
  const double before = bench::processor_seconds();
  const ident::Solution solution = ident::solve(plan, control);
  return {solution.fit.iterations, solution.runtime_s.total, bench::processor_seconds() - before, largest_error(solution, truth)};
}

Run random_problem(std::size_t lines) {
  const auto [a, b, both] = bench::random_sets(lines);
  ident::Scene scene = random_scene();
  frf::NoiseModel noise{.kind = frf::NoiseKind::uniform, .level = level};
  scene.noise = ident::NoiseSection{.model = "uniform", .level = level, .frf_model = noise};
  std::vector<frf::FrfSet> parts;
  parts.push_back(frf::polluted(a, noise, 1, 0, 0));
  parts.push_back(frf::polluted(b, noise, 1, 0, 1));
  std::vector<frf::FrfSet> whole;
  whole.push_back(frf::polluted(both, noise, 1, 0, 2));
  const auto plan = ident::make_plan(scene, std::move(parts), std::move(whole));
  ident::Control control;
  control.detail = ident::Detail::estimates;
  return run(*plan, bench::true_unknowns(), control);
}

/// Substructures side by side or the assembly, number by number of `get`(set, place).
template <class Number, class Get>
void write_system(const std::vector<const frf::FrfSet*>& sets, const Get& get, std::ofstream& out) {
  constexpr std::size_t size = 24;
  const std::size_t lines = sets.front()->header.lines();
  std::vector<Number> all(lines * size * size);
  std::size_t first = 0;
  for (const frf::FrfSet* set : sets) {
    const std::size_t own = set->header.response.size();
    for (std::size_t line = 0; line < lines; ++line) {
      for (std::size_t r = 0; r < own; ++r) {
        for (std::size_t c = 0; c < own; ++c)
          all[(line * size + first + r) * size + first + c] = get(*set, set->index(line, r, c));
      }
    }
    first += own;
  }
  out.write(reinterpret_cast<const char*>(all.data()), static_cast<std::streamsize>(all.size() * sizeof(Number)));
}

/// What bench/peer/likelihood.py reads.
void write_for_peer(const bench::RandomSets& sets, const std::vector<double>& truth, const std::filesystem::path& file) {
  std::ofstream out(file, std::ios::binary);
  const auto write = [&out](const std::vector<double>& values) {
    out.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(values.size() * sizeof(double)));
  };
  write(sets.a.header.frequency_hz);
  const std::vector<const frf::FrfSet*> parts = {&sets.a, &sets.b}, whole = {&sets.both};
  for (const auto& system : {parts, whole}) {
    write_system<Complex>(
        system, [](const frf::FrfSet& set, std::size_t i) { return set.values[i]; }, out);
  }
  for (const auto& system : {parts, whole}) {
    write_system<double>(
        system, [](const frf::FrfSet& set, std::size_t i) { return set.variance[i].real(); }, out);
  }
  write(truth);
}

/// One thread each, the peer from 0.8 of the truth, ours from its own start.
void compare_with_peer(std::size_t lines, bench::Promises& promises) {
  bench::RandomSets sets = bench::random_sets(lines);
  std::mt19937 generator(7);
  for (frf::FrfSet* set : {&sets.a, &sets.b, &sets.both}) bench::pollute(*set, level, generator);
  const TestFolder folder;
  write_for_peer(sets, bench::true_unknowns(), folder / "lines.bin");
  const auto output =
      bench::peer_output(fmt::format("likelihood.py {} {} 24 0,1,14,15", (folder / "lines.bin").string(), lines), promises);
  if (!output) return;
  std::istringstream text(*output);
  double seconds = 0.0;
  std::size_t iterations = 0;
  text >> seconds >> iterations;
  const auto plan = ident::make_plan(random_scene(), std::vector{sets.a, sets.b}, std::vector{sets.both});
  ident::Control control;
  control.threads = 1;
  control.detail = ident::Detail::estimates;
  const ident::Solution solution = ident::solve(*plan, control);
  std::vector<double> peer(solution.unknowns.size(), std::numeric_limits<double>::quiet_NaN());
  for (double& value : peer) text >> value;
  const double difference = largest_error(solution, peer);
  fmt::print(
      "{:5} lines x (20 + 4) coordinates, one thread: numpy {:.2f} s, {} iterations; jointid {:.2f} s, {} iterations; {:.1f} "
      "times, at least 5; largest difference {:.1g} standard errors\n",
      lines, seconds, iterations, solution.runtime_s.total, solution.fit.iterations, seconds / solution.runtime_s.total,
      difference);
  promises.speed_at_least("times faster than numpy", seconds / solution.runtime_s.total, 5.0);
  promises.at_most("difference from numpy, standard errors", difference, 0.01);
}

/// Median over trials of a case with 5 % noise, one thread: ms by the clock and of processor time.
Run small_case(const std::string& name, const std::vector<ident::Equation>& equations, std::size_t trials) {
  const problems::Problem problem = problems::make(name);
  ident::Scene scene = problems::scene(problem);
  scene.identify.method = ident::Method::likelihood;
  if (!equations.empty()) scene.identify.equations = equations;
  std::vector<double> seconds, processor_seconds;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    const auto plan = problems::plan(scene, problems::polluted(problem, 1, trial));
    ident::Control control;
    control.threads = 1;
    const Run each = run(*plan, {}, control);
    seconds.push_back(each.seconds);
    processor_seconds.push_back(each.processor_seconds);
  }
  return {0, median(seconds), median(processor_seconds), 0.0};
}

void measure_small(const std::string& name, const std::vector<ident::Equation>& equations, std::size_t trials, double limit_ms,
                   bench::Promises& promises) {
  const Run run = small_case(name, equations, trials);
  fmt::print("case {}, 5 % noise, one thread, median of {} trials   {:8.1f} ms, {:.1f} of processor time   less than {:g}\n", name,
             trials, 1e3 * run.seconds, 1e3 * run.processor_seconds, limit_ms);
  promises.speed_at_most(name + ", ms", 1e3 * run.seconds, limit_ms);
}

/// Problem bolts with its 157 lines, or eight of them.
Run bolts(bool few) {
  const problems::Problem problem = problems::make("bolts");
  ident::Scene scene = problems::scene(problem);
  scene.identify.method = ident::Method::likelihood;
  if (few) scene.frequency.range_hz = {{3000.0, 3280.0}};
  const auto plan = problems::plan(scene, problems::polluted(problem, 1, 0));
  return run(*plan, ident::joint_values(*plan, scene.truth, "[truth]"), {});
}

void measure_lines(bool quick, bench::Promises& promises) {
  double first = 0.0;
  for (const std::size_t lines : {100U, 300U, 1000U}) {
    if (quick && lines > 100) break;
    const Run run = random_problem(lines);
    const double each = run.processor_seconds / static_cast<double>(run.iterations);
    if (lines == 100) first = each;
    const double exponent = lines == 100 ? 1.0 : std::log(each / first) / std::log(static_cast<double>(lines) / 100.0);
    fmt::print(
        "{:5} lines x (20 + 4) coordinates, 1 % noise   {:8.2f} s, {:.2f} of processor time, {} iterations, {:.1f} ms each, exponent "
        "{:.2f}, {:.0f} MB, largest error {:.1f} standard errors\n",
        lines, run.seconds, run.processor_seconds, run.iterations, 1e3 * each, exponent, bench::peak_megabytes(), run.largest_error);
    promises.speed_at_most(fmt::format("{} lines, s", lines), run.seconds, 120.0);
    promises.speed_at_most(fmt::format("{} lines, exponent", lines), exponent, 1.2);
    promises.at_most(fmt::format("{} lines, largest error in standard errors", lines), run.largest_error, 5.0);
  }
}

void measure_bolts(bool quick, bench::Promises& promises) {
  const Run run = bolts(quick);
  fmt::print(
      "bolts, {} lines x (36 + 24) coordinates, 1 % noise, {} module blas   {:8.2f} s, {:.2f} of processor time, {} iterations, "
      "{:.0f} MB, largest error {:.1f} standard errors\n",
      quick ? 8 : 157, dense::has_blas() ? "with" : "without", run.seconds, run.processor_seconds, run.iterations,
      bench::peak_megabytes(), run.largest_error);
  if (dense::has_blas()) promises.speed_at_most("bolts, s", run.seconds, 60.0);
  promises.at_most("bolts, largest error in standard errors", run.largest_error, 5.0);
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  const std::vector<std::string> parts = {"A1", "H4", "lines", "numpy", "bolts"};
  for (const std::string& part : line.choice(0, parts, parts)) {
    if (part == "A1") measure_small("A1", {}, line.quick() ? 3 : 15, 100.0, promises);
    if (part == "H4") measure_small("H4", {ident::Equation::nn}, line.quick() ? 1 : 5, 2000.0, promises);
    if (part == "lines") measure_lines(line.quick(), promises);
    if (part == "numpy") compare_with_peer(line.quick() ? 30 : 100, promises);
    if (part == "bolts") measure_bolts(line.quick(), promises);
  }
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "[PART ...]", measure); }

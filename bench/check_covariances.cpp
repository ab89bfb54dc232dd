// `jointid check` on files whose covariances say that all responses to a blow share the noise of the hammer's signal (10 % of
// every FRF), beside noise of each sensor, 0.05 % of its rms: one sensor of the assembly that reads 2 % too much, and clean
// scenes. With the covariances, and with the variances alone. Promised: docs/checking-data.md.
#include <fmt/core.h>

#include <cmath>
#include <string>

#include "base/random.hpp"
#include "bench/bench.hpp"
#include "frf/noise/variance_law.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/planted.hpp"
#include "problems/problem.hpp"

namespace {

using namespace jointid;

constexpr double hammer = 0.1, sensor = 0.0005;

/// The set with such errors, and what it knows of them.
frf::FrfSet noisy(const frf::FrfSet& exact, std::uint64_t seed, std::uint64_t number) {
  frf::FrfSet out = exact;
  const std::size_t rows = out.header.response.size(), columns = out.header.reference.size();
  out.coherence.clear();
  out.header.noise = frf::NoiseRecord::variance;
  out.header.averages = 0.0;
  out.variance.assign(out.values.size(), 0.0);
  out.factor.rank = 1;
  out.factor.rows.assign(out.values.size(), 0.0);
  out.factor.diagonal.assign(out.values.size(), 0.0);
  const auto factor = [&](std::size_t line) {
    return std::sqrt(frf::squared_factor(out.header.quantity, out.header.frequency_hz[line]));
  };
  const auto draw = [&](std::uint64_t at) {
    const auto pair = normal_numbers({seed, number}, at);
    return Complex(pair[0], pair[1]) / std::sqrt(2.0);
  };
  const auto noise_of_sensor = [&](std::size_t r) {  // blows are of one strength
    double square = 0.0;
    for (std::size_t line = 0; line < out.header.lines(); ++line) {
      for (std::size_t c = 0; c < columns && factor(line) > 0.0; ++c)
        square += std::norm(exact.values[out.index(line, r, c)] / factor(line));
    }
    return sensor * std::sqrt(square / static_cast<double>(out.header.lines() * columns));
  };
  for (std::size_t r = 0; r < rows; ++r) {
    const double own = noise_of_sensor(r);
    for (std::size_t c = 0; c < columns; ++c) {
      for (std::size_t line = 0; line < out.header.lines(); ++line) {
        const std::size_t at = out.index(line, r, c);
        const Complex shared = hammer * exact.values[at];
        const double alone = own * factor(line);
        out.values[at] += shared * draw((line * columns + c) * 2) + alone * draw((at + 1) * 2 + 1);
        out.factor.rows[at] = shared;
        out.factor.diagonal[at] = alone * alone;
        const double half = 0.5 * (std::norm(shared) + alone * alone);
        out.variance[at] = {half, half};
      }
    }
  }
  return out;
}

problems::Measurement noisy(const problems::Measurement& exact, std::uint64_t seed, bool covariances) {
  problems::Measurement out;
  std::uint64_t number = 0;
  for (const frf::FrfSet& set : exact.substructures) out.substructures.push_back(noisy(set, seed, number++));
  out.assembly = noisy(exact.assembly, seed, number);
  if (covariances) return out;
  for (frf::FrfSet& set : out.substructures) set.factor = {};
  out.assembly.factor = {};
  return out;
}

struct Counts {
  std::size_t found = 0, planted = 0, alarms = 0, clean = 0;
};

void add(const problems::Problem& problem, std::uint64_t seed, bool covariances, Counts& to) {
  const ident::Scene scene = problems::scene(problem);
  const problems::Planted planted = problems::plant(problem, ident::SuspectKind::gain, {.level = 0.0}, seed);
  const std::vector<ident::Suspect> suspects = problems::check(scene, noisy(planted.data, seed, covariances)).suspects;
  const bool named = !suspects.empty() && suspects.front().kind == planted.kind && frf::has(suspects.front().dofs, planted.dofs.front());
  to.found += named ? 1 : 0;  // in either file: H_ij and H_ji, which tell it, have the hammer's noise
  ++to.planted;
  const ident::CheckResult result = problems::check(scene, noisy({problem.substructures, problem.assembly}, seed, covariances));
  to.alarms += result.verdict != ident::Verdict::clean ? 1 : 0;
  ++to.clean;
}

void print(const char* what, const Counts& of) {
  fmt::print("  {:20} culprit first {} of {}; clean scenes called worse than clean {} of {}\n", what, of.found, of.planted,
             of.alarms, of.clean);
}

void measure_all(const bench::CommandLine& line, bench::Promises& promises) {
  const std::size_t seeds = line.count(0, 40, 6);
  for (const char* name : {"A1", "rig1", "bolts"}) {
    if (seeds < 40 && name == std::string("bolts")) break;
    const problems::Problem problem = problems::make(name);
    Counts with, alone;
    double seconds = 0.0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      seconds += bench::seconds([&] { add(problem, seed, true, with); });
      add(problem, seed, false, alone);
    }
    fmt::print("{}: 10 % of the hammer, 0.05 % of each sensor; {:.2f} s a check with covariances\n", name,
               seconds / static_cast<double>(2 * seeds));
    print("with covariances", with);
    print("variances alone", alone);
    const auto share = [&](std::size_t count) { return static_cast<double>(count) / static_cast<double>(seeds); };
    promises.at_least(std::string(name) + ": culprits that come first", share(with.found), bench::least_share(0.8, seeds));
    promises.at_most(std::string(name) + ": clean scenes called worse", share(with.alarms), 1.0 - bench::least_share(0.97, seeds));
  }
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "[SEEDS]", measure_all); }

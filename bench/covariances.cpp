// Method "likelihood" on simulated hammer tests of five blows whose responses share the noise of the hammer's signal (case A1,
// FRFs, variances and covariances as `jointid frf` makes them of the blows): coverage of the 95 % intervals and rms errors with
// the covariances and with the variances alone, and the time that covariances cost. The same of shaker tests with all forces at
// once, two and two of which depend on each other, with what their references have in common and without. Promised:
// docs/likelihood.md.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random.hpp"
#include "bench/bench.hpp"
#include "ident/identify.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"
#include "records/estimate/estimate.hpp"
#include "records/estimate/several_forces.hpp"

namespace {

using namespace jointid;

constexpr std::size_t blows = 5;
constexpr double hammer = 0.02;   ///< noise of the force's signal over the force, on every line
constexpr double sensor = 0.002;  ///< noise of a response over its median |H|

constexpr std::size_t segments = 60;  ///< with all forces at once
constexpr double coupled = 0.9;       ///< correlation of every second force with the one before
constexpr double motion = 0.02;       ///< noise of a response in a segment over its median |H|

/// What a test knows of its errors.
enum class Known { variances, covariances, references };

/// Noise of a channel on all blows and lines.
Complex noise(const RandomStream& stream, std::uint64_t channel, std::size_t blow, std::size_t line) {
  const auto z = normal_numbers(stream, blow * 4096 + line, channel);
  return Complex(z[0], z[1]) / std::sqrt(2.0);
}

/// The blows on one reference of a set; forces of 1 N.
records::Spectra blow(const frf::FrfSet& exact, std::size_t reference, const RandomStream& stream) {
  const std::size_t lines = exact.header.lines(), responses = exact.header.response.size();
  records::Spectra out{lines, responses, blows, {}, {}};
  std::vector<double> floor(responses);
  for (std::size_t r = 0; r < responses; ++r) {
    std::vector<double> sizes;
    for (std::size_t l = 0; l < lines; ++l) sizes.push_back(std::abs(exact.values[exact.index(l, r, reference)]));
    floor[r] = sensor * median(std::move(sizes));
  }
  const std::uint64_t channel = reference * (responses + 1);
  for (std::size_t h = 0; h < blows; ++h) {
    for (std::size_t l = 0; l < lines; ++l) out.force.push_back(1.0 + hammer * noise(stream, channel, h, l));
    for (std::size_t r = 0; r < responses; ++r) {
      for (std::size_t l = 0; l < lines; ++l) {
        out.motion.push_back(exact.values[exact.index(l, r, reference)] + floor[r] * noise(stream, channel + r + 1, h, l));
      }
    }
  }
  return out;
}

frf::FrfSet measured(const frf::FrfSet& exact, const RandomStream& stream, bool covariance) {
  const std::size_t lines = exact.header.lines(), responses = exact.header.response.size(), references = exact.header.reference.size();
  const std::size_t pairs = frf::pair_count(responses);
  frf::FrfSet out = exact;
  out.coherence.clear();
  out.header.noise = frf::NoiseRecord::variance;
  out.header.averages = blows;
  out.header.repeats = 0;
  out.variance.resize(out.values.size());
  if (covariance) out.covariance.resize(lines * pairs * references);
  for (std::size_t c = 0; c < references; ++c) {
    const records::Estimate of =
        records::estimate(blow(exact, c, stream), records::Estimator::h1, records::NoiseFrom::residuals, blows);
    for (std::size_t l = 0; l < lines; ++l) {
      for (std::size_t r = 0; r < responses; ++r) {
        out.values[out.index(l, r, c)] = of.frf[l * responses + r];
        out.variance[out.index(l, r, c)] = of.variance[l * responses + r];
      }
      if (!covariance) continue;
      for (std::size_t p = 0; p < pairs; ++p) out.covariance[(l * pairs + p) * references + c] = of.covariance[l * pairs + p];
    }
  }
  return out;
}

/// All forces at once, one line at a time.
frf::FrfSet measured_at_once(const frf::FrfSet& exact, const RandomStream& stream, Known known) {
  const std::size_t lines = exact.header.lines(), responses = exact.header.response.size(),
                    references = exact.header.reference.size();
  const std::size_t pairs = frf::pair_count(responses);
  records::SeveralForces all{lines, references, responses, segments, {}, {}};
  all.force.resize(segments * references * lines);
  all.motion.resize(segments * responses * lines);
  for (std::size_t r = 0; r < responses; ++r) {
    std::vector<double> sizes;
    for (std::size_t i = 0; i < lines * references; ++i) {
      sizes.push_back(std::abs(exact.values[exact.index(i / references, r, i % references)]));
    }
    const double floor = motion * median(std::move(sizes));
    for (std::size_t i = 0; i < segments * lines; ++i) {
      all.motion[(i / lines * responses + r) * lines + i % lines] = floor * noise(stream, r, i / lines, i % lines);
    }
  }
  for (std::size_t h = 0; h < segments; ++h) {
    for (std::size_t l = 0; l < lines; ++l) {
      Complex before = 0.0;
      for (std::size_t c = 0; c < references; ++c) {
        const Complex own = noise(stream, responses + c, h, l);
        const Complex force = c % 2 == 0 ? own : coupled * before + std::sqrt(1.0 - coupled * coupled) * own;
        all.force[(h * references + c) * lines + l] = before = force;
        for (std::size_t r = 0; r < responses; ++r) {
          all.motion[(h * responses + r) * lines + l] += exact.values[exact.index(l, r, c)] * force;
        }
      }
    }
  }
  records::SeveralEstimates made = records::estimate(all, segments);
  frf::FrfSet out = exact;
  out.coherence.clear();
  out.header.noise = frf::NoiseRecord::variance;
  out.header.averages = segments;
  out.header.repeats = 0;
  out.variance.resize(out.values.size());
  out.covariance.resize(lines * pairs * references);
  for (std::size_t c = 0; c < references; ++c) {
    const records::Estimate& of = made.of_force[c];
    for (std::size_t l = 0; l < lines; ++l) {
      for (std::size_t r = 0; r < responses; ++r) {
        out.values[out.index(l, r, c)] = of.frf[l * responses + r];
        out.variance[out.index(l, r, c)] = of.variance[l * responses + r];
      }
      for (std::size_t p = 0; p < pairs; ++p) out.covariance[(l * pairs + p) * references + c] = of.covariance[l * pairs + p];
    }
  }
  if (known == Known::references) out.reference_correlation = std::move(made.reference_correlation);
  return out;
}

template <class Measure>
problems::Measurement measured_by(const problems::Problem& problem, std::uint64_t seed, const Measure& measure) {
  problems::Measurement out;
  std::uint64_t set = 0;
  for (const frf::FrfSet& exact : problem.substructures) out.substructures.push_back(measure(exact, {seed, 0, set++}));
  out.assembly = measure(problem.assembly, {seed, 0, set});
  return out;
}

problems::Measurement measured(const problems::Problem& problem, std::uint64_t seed, Known known) {
  return measured_by(problem, seed, [&](const frf::FrfSet& exact, const RandomStream& stream) {
    return measured(exact, stream, known != Known::variances);
  });
}

problems::Measurement measured_at_once(const problems::Problem& problem, std::uint64_t seed, Known known) {
  return measured_by(problem, seed, [&](const frf::FrfSet& exact, const RandomStream& stream) {
    return measured_at_once(exact, stream, known);
  });
}

/// Errors of all unknowns over tests.
struct Figures {
  std::size_t inside = 0, count = 0, not_ok = 0;
  double squares = 0.0;  ///< of errors in parts of the largest unknown of their unit
  double chi_square = 0.0;
  std::vector<double> times;

  double coverage() const { return static_cast<double>(inside) / static_cast<double>(count); }
  double rms() const { return std::sqrt(squares / static_cast<double>(count)); }
};

void add(const problems::Problem& problem, const ident::Scene& scene, problems::Measurement data, Figures& to) {
  const auto plan = problems::plan(scene, std::move(data));
  ident::Control control;
  control.threads = 1;
  control.detail = ident::Detail::estimates;
  ident::Solution solution;
  to.times.push_back(bench::seconds([&] { solution = ident::solve(*plan, control); }));
  to.not_ok += solution.status == ident::Status::ok ? 0 : 1;
  to.chi_square += solution.fit.chi_square->value / solution.fit.chi_square->degrees_of_freedom;
  for (std::size_t i = 0; i < solution.unknowns.size(); ++i) {
    const ident::Estimate& unknown = solution.unknowns[i];
    const double truth = problem.unknowns[i].value;
    if (truth == 0.0 || !unknown.ci95) continue;
    double largest = 0.0;
    for (std::size_t k = 0; k < solution.unknowns.size(); ++k) {
      if (solution.unknowns[k].unit == unknown.unit) largest = std::max(largest, std::abs(problem.unknowns[k].value));
    }
    to.inside += (*unknown.ci95)[0] <= truth && truth <= (*unknown.ci95)[1] ? 1U : 0U;
    to.squares += std::pow((unknown.value - truth) / largest, 2);
    ++to.count;
  }
}

void print(const char* what, const Figures& of, std::size_t tests) {
  fmt::print("  {:23} coverage {:.3f}, rms error {:.5f}, chi²/f {:.3f}, not ok {} of {}, {:.0f} ms\n", what, of.coverage(),
             of.rms(), of.chi_square / static_cast<double>(tests), of.not_ok, tests, 1e3 * median(of.times));
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  const std::size_t tests = line.count(0, 400, 8);
  const problems::Problem problem = problems::make(line.word(1, "A1"));
  ident::Scene scene = problems::scene(problem);
  scene.identify.method = ident::Method::likelihood;
  scene.identify.equations = {ident::Equation::nn, ident::Equation::nj};
  scene.noise.reset();
  fmt::print("{}: {} tests of {} blows, noise of the hammer {:g} %, of a sensor {:g} % of the median FRF\n", problem.name, tests, blows,
             100.0 * hammer, 100.0 * sensor);
  Figures with, alone;
  for (std::uint64_t seed = 1; seed <= tests; ++seed) {
    add(problem, scene, measured(problem, seed, Known::covariances), with);
    add(problem, scene, measured(problem, seed, Known::variances), alone);
  }
  print("with covariances", with, tests);
  print("with variances alone", alone, tests);
  promises.at_least("coverage with covariances", with.coverage(), bench::least_share(0.93, with.count));
  promises.at_most("coverage with covariances", with.coverage(), 1.0 - bench::least_share(0.03, with.count));
  promises.at_most("rms error with covariances over that with variances alone", with.rms() / alone.rms(), 0.8);

  fmt::print("All forces at once, {} segments, correlation {:g} of two and two, noise of a motion {:g} %\n", segments, coupled,
             100.0 * motion);
  Figures shared, apart;
  for (std::uint64_t seed = 1; seed <= tests; ++seed) {
    add(problem, scene, measured_at_once(problem, seed, Known::references), shared);
    add(problem, scene, measured_at_once(problem, seed, Known::covariances), apart);
  }
  print("with that of references", shared, tests);
  print("references apart", apart, tests);
  promises.at_least("coverage with what references share", shared.coverage(), bench::least_share(0.92, shared.count));
  promises.at_most("coverage with what references share", shared.coverage(), 1.0 - bench::least_share(0.03, shared.count));
  promises.at_most("rms error with it over that without", shared.rms() / apart.rms(), 1.0);
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "[TESTS [CASE]]", measure); }

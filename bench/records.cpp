// FRFs of simulated hammer tests: whether their covariances are what tests scatter by (400 tests of five blows, noise of the
// hammer's signal common to all responses and noise of each sensor), what variances alone would say of the ratio of two
// responses, what an exponential window leaves of a resonance before and after its damping is taken out, and the time for 12
// responses. Promised: docs/records.md.
#include <fmt/core.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/random.hpp"
#include "bench/bench.hpp"
#include "records/estimate/measured_frfs.hpp"

namespace {

using namespace jointid;
using namespace jointid::records;

constexpr double rate_hz = 1024.0;

struct Mode {
  double hz, damping;
  std::array<double, 3> shape;
};
constexpr std::array<Mode, 3> modes = {
    {{40.0, 0.02, {1.0, 0.6, -0.8}}, {97.3, 0.01, {0.7, -1.0, 0.5}}, {180.0, 0.01, {0.4, 0.8, 1.0}}}};

Complex step_of(const Mode& mode, double damping_factor) {
  const double w = 2.0 * std::numbers::pi * mode.hz;
  return std::exp(Complex{-mode.damping * damping_factor * w, w} / rate_hz);
}

struct Blown {
  std::size_t samples = 1024, responses = 3;
  double hammer = 0.0, sensor = 0.0;  ///< noise, N and m
  double damping_factor = 1.0;
};

/// Response r repeats the shapes of r mod 3.
Record blow(const Blown& how, std::uint64_t seed, std::uint64_t number) {
  Record record{"simulated", rate_hz, {{"F", frf::Dof::parse("1:+Z"), ChannelKind::force, {}}}};
  std::vector<double> force(how.samples);
  for (std::size_t t = 0; t < 3; ++t) force[t + 8] = 100.0 * std::sin(std::numbers::pi * (static_cast<double>(t) + 1.0) / 4.0);
  for (std::size_t r = 0; r < how.responses; ++r) {
    std::vector<double> motion(how.samples);
    for (const Mode& mode : modes) {
      const Complex step = step_of(mode, how.damping_factor);
      Complex state = 0.0;
      for (std::size_t t = 0; t < how.samples; ++t) {
        state = step * state + force[t];
        motion[t] += mode.shape[r % 3] * state.imag();
      }
    }
    for (std::size_t t = 0; t < how.samples; ++t) motion[t] += how.sensor * normal_numbers({seed, number, r + 1}, t)[0];
    record.channels.push_back({fmt::format("x{}", r),
                               {static_cast<std::int64_t>(r) + 2, frf::Direction::z, 1},
                               ChannelKind::displacement,
                               std::move(motion)});
  }
  for (std::size_t t = 0; t < how.samples; ++t) force[t] += how.hammer * normal_numbers({seed, number, 0}, t)[0];
  record.channels[0].samples = std::move(force);
  return record;
}

/// The transform of the sampled impulse response at iω.
Complex exact(std::size_t r, double hz, double damping_factor) {
  const Complex z = std::polar(1.0, -2.0 * std::numbers::pi * hz / rate_hz);
  Complex sum = 0.0;
  for (const Mode& mode : modes) {
    const Complex step = step_of(mode, damping_factor);
    sum += mode.shape[r % 3] * (1.0 / (1.0 - step * z) - 1.0 / (1.0 - std::conj(step) * z)) / Complex{0.0, 2.0};
  }
  return sum;
}

/// Sums over the tests, [line, pair].
struct Scatter {
  std::vector<Complex> sample, stated;
  double ratio_sample = 0.0, ratio_stated = 0.0, ratio_alone = 0.0;  ///< of H_2/H_1, with covariances and with variances alone
};

void add(const MeasuredFrfs& made, const MeasuredFrfs& clean, Scatter& sums) {
  const std::size_t lines = made.set.header.lines();
  sums.sample.resize(6 * lines);
  sums.stated.resize(6 * lines);
  for (std::size_t line = 8; line < lines; ++line) {
    std::array<Complex, 3> truth, error;
    for (std::size_t r = 0; r < 3; ++r) {
      truth[r] = clean.set.values[line * 3 + r];
      error[r] = made.set.values[line * 3 + r] - truth[r];
    }
    const auto c = [&](std::size_t r, std::size_t s) { return made.set.covariance[line * 6 + frf::pair_index(r, s)]; };
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t s = 0; s <= r; ++s) {
        sums.sample[line * 6 + frf::pair_index(r, s)] += error[r] * std::conj(error[s]);
        sums.stated[line * 6 + frf::pair_index(r, s)] += c(r, s);
      }
    }
    // Relative error of H_1/H_0, e_1/H_1 − e_0/H_0.
    const double alone = c(1, 1).real() / std::norm(truth[1]) + c(0, 0).real() / std::norm(truth[0]);
    const double scale = 1.0 / std::max(alone, 1e-300);
    sums.ratio_alone += 1.0;
    sums.ratio_stated += scale * (alone - 2.0 * (c(1, 0) / (truth[1] * std::conj(truth[0]))).real());
    sums.ratio_sample += scale * std::norm(error[1] / truth[1] - error[0] / truth[0]);
  }
}

void covariances(std::size_t tests, bench::Promises& promises) {
  Scatter sums;
  FrfOptions options;
  options.highest_hz = 250.0;
  const MeasuredFrfs clean = make_frfs(std::vector{blow({}, 0, 0)}, options);
  for (std::size_t test = 0; test < tests; ++test) {
    std::vector<Record> records;
    for (std::uint64_t k = 0; k < 5; ++k) records.push_back(blow({.hammer = 0.5, .sensor = 0.05}, 11 + test, k));
    add(make_frfs(records, options), clean, sums);
  }
  double own = 0.0, between = 0.0, count = 0.0;
  for (std::size_t line = 8; line < sums.sample.size() / 6; ++line) {
    const auto of = [&](const std::vector<Complex>& from, std::size_t r, std::size_t s) {
      return from[line * 6 + frf::pair_index(r, s)];
    };
    for (std::size_t r = 0; r < 3; ++r) {
      own += of(sums.sample, r, r).real() / of(sums.stated, r, r).real() / 3.0;
      for (std::size_t s = 0; s < r; ++s) {
        between += std::norm(of(sums.sample, r, s) - of(sums.stated, r, s)) /
                   (of(sums.stated, r, r) * of(sums.stated, s, s)).real() / 3.0;
      }
    }
    count += 1.0;
  }
  fmt::print("{} tests of 5 blows, 3 responses, {} lines\n", tests, static_cast<int>(count));
  fmt::print("  variance that tests scatter by, over the stated one       {:.3f}\n", own / count);
  fmt::print("  covariances: rms difference, in parts of √(C_rr C_ss)     {:.3f} (chance alone {:.3f})\n",
             std::sqrt(between / count), 1.0 / std::sqrt(static_cast<double>(tests)));
  fmt::print("  H_1/H_0: scattered variance over the one with covariances {:.3f}\n", sums.ratio_sample / sums.ratio_stated);
  fmt::print("           scattered variance over the one with variances   {:.4f}\n", sums.ratio_sample / sums.ratio_alone);
  const double chance = 5.0 / std::sqrt(static_cast<double>(tests));
  promises.at_most("variance that tests scatter by, over the stated one", own / count, 1.0 + chance / 5.0);
  promises.at_least("variance that tests scatter by, over the stated one", own / count, 1.0 - chance / 5.0);
  promises.at_most("rms difference of covariances", std::sqrt(between / count), 0.3 * chance);
  promises.at_most("H_1/H_0: variance over that with covariances", sums.ratio_sample / sums.ratio_stated, 1.0 + chance / 2.0);
  promises.at_least("H_1/H_0: variance over that with covariances", sums.ratio_sample / sums.ratio_stated, 1.0 - chance / 2.0);
}

/// Light damping: without a window the blow is cut off; with one its damping has to go.
void exponential_window(bench::Promises& promises) {
  const Record record = blow({.samples = 2048, .damping_factor = 0.2}, 0, 0);
  fmt::print("ζ = 0.4 and 0.2 %, 2 s: largest error of three FRFs to 250 Hz, in parts of the largest FRF\n");
  FrfOptions options;
  options.highest_hz = 250.0;
  const auto worst = [&] {
    const MeasuredFrfs made = make_frfs(std::vector{record}, options);
    double error = 0.0, size = 0.0;
    for (std::size_t i = 60; i < made.set.values.size(); ++i) {
      const Complex truth = exact(i % 3, made.set.header.frequency_hz[i / 3], 0.2);
      error = std::max(error, std::abs(made.set.values[i] - truth));
      size = std::max(size, std::abs(truth));
    }
    return error / size;
  };
  fmt::print("  no window                              {:.4f}\n", worst());
  options.decay_time_s = 2.0 / 7.0;
  const double corrected = worst();
  fmt::print("  exponential, e⁻⁷ at the end, corrected {:.4f}\n", corrected);
  promises.at_most("error after the damping is taken out", corrected, 0.02);
}

void time_of_a_test(bool quick, bench::Promises& promises) {
  std::vector<Record> records;
  const std::size_t samples = quick ? 4096 : 51200;
  for (std::uint64_t k = 0; k < 10; ++k)
    records.push_back(blow({.samples = samples, .responses = 12, .hammer = 0.5, .sensor = 0.05}, 5, k));
  bench::Times times;
  for (int repeat = 0; repeat < 3; ++repeat) times.add([&] { make_frfs(records, {}); });
  fmt::print("10 blows, 12 responses, {} samples: {:.2f} s with all covariances, {:.0f} MB\n", samples, bench::least(times.wall),
             bench::peak_megabytes());
  promises.speed_at_most("10 blows of 12 responses, s", bench::least(times.wall), 5.0);
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  covariances(line.count(0, 400, 40), promises);
  exponential_window(promises);
  time_of_a_test(line.quick(), promises);
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "[TESTS]", measure); }

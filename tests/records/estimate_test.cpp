#include "records/estimate/estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.hpp"
#include "frf/set/frf_set.hpp"
#include "frf/set/h1.hpp"
#include "records/estimate/measured_frfs.hpp"

namespace jointid::records {
namespace {

constexpr std::size_t lines = 3, responses = 3;

/// True FRFs of three lines and responses.
Complex truth(std::size_t r, std::size_t line) {
  return Complex{1.0 + 0.7 * static_cast<double>(r), -0.4 * static_cast<double>(line)} * 1e-3;
}

/// Noise of one blow: on the force of the hammer, common to all responses; on a motion common to responses 1 and 2; of each
/// sensor.
struct Noise {
  double hammer = 0.0, shared = 0.0, own = 0.0;
};

/// A blow differs from the others by `spread` in strength.
Spectra simulated(std::size_t count, const Noise& noise, double spread, std::uint64_t seed) {
  Spectra out{lines, responses, count, {}, {}};
  for (std::size_t h = 0; h < count; ++h) {
    const auto draw = [&](std::size_t what, std::size_t line) {
      const auto pair = normal_numbers({seed, h}, what * lines + line);
      return Complex{pair[0], pair[1]} / std::sqrt(2.0);
    };
    std::vector<Complex> force;
    for (std::size_t line = 0; line < lines; ++line)
      force.push_back(100.0 * std::exp(spread * normal_numbers({seed, h}, 100)[0]) *
                      std::polar(1.0, 0.3 * static_cast<double>(line)));
    for (std::size_t line = 0; line < lines; ++line) out.force.push_back(force[line] + noise.hammer * draw(0, line));
    for (std::size_t r = 0; r < responses; ++r) {
      for (std::size_t line = 0; line < lines; ++line) {
        out.motion.push_back(truth(r, line) * force[line] + (r > 0 ? noise.shared * draw(1, line) : 0.0) +
                             noise.own * draw(2 + r, line));
      }
    }
  }
  return out;
}

TEST(Estimate, ExactSpectraGiveTheFrfsByEveryEstimator) {
  for (const Estimator estimator : {Estimator::h1, Estimator::h2, Estimator::hv}) {
    const Estimate made = estimate(simulated(4, {}, 0.3, 1), estimator, NoiseFrom::residuals, 4.0);
    for (std::size_t line = 0; line < lines; ++line) {
      for (std::size_t r = 0; r < responses; ++r) {
        EXPECT_LE(std::abs(made.frf[line * responses + r] - truth(r, line)), 1e-15 * std::abs(truth(r, line)) * 4.0);
        EXPECT_NEAR(made.coherence[line * responses + r], 1.0, 1e-14);
        EXPECT_LE(made.variance[line * responses + r].real(), 1e-30 * std::norm(truth(r, line)));
      }
    }
  }
}

TEST(Estimate, ResidualsGiveTheVarianceOfTheCoherence) {
  const Estimate made = estimate(simulated(6, {3.0, 0.002, 0.004}, 0.3, 2), Estimator::h1, NoiseFrom::residuals, 6.0);
  for (std::size_t line = 0; line < lines; ++line) {
    for (std::size_t r = 0; r < responses; ++r) {
      const std::size_t at = line * responses + r;
      const Complex expected = frf::h1_part_variances(made.frf[at], made.coherence[at], 6.0);
      EXPECT_NEAR(made.variance[at].real(), expected.real(), 1e-10 * expected.real());
      const Complex own = made.covariance[line * frf::pair_count(responses) + frf::pair_index(r, r)];
      EXPECT_NEAR(own.real(), expected.real() + expected.imag(), 1e-10 * own.real());
    }
  }
}

/// |H1| ≤ |Hv| ≤ |H2|, and H1/H2 is the coherence; another unit of the force changes Hv by its factor.
TEST(Estimate, HvLiesBetweenAndDoesNotDependOnUnits) {
  Spectra spectra = simulated(5, {5.0, 0.0, 0.01}, 0.3, 3);
  const auto made = [&](Estimator estimator) { return estimate(spectra, estimator, NoiseFrom::residuals, 5.0).frf; };
  const auto h1 = made(Estimator::h1), h2 = made(Estimator::h2), hv = made(Estimator::hv);
  const auto coherence = estimate(spectra, Estimator::h1, NoiseFrom::residuals, 5.0).coherence;
  for (std::size_t i = 0; i < h1.size(); ++i) {
    EXPECT_LE(std::abs(h1[i]), std::abs(hv[i]));
    EXPECT_LE(std::abs(hv[i]), std::abs(h2[i]));
    EXPECT_NEAR(std::abs(h1[i] / h2[i] - coherence[i]), 0.0, 1e-14);
  }
  for (Complex& f : spectra.force) f *= 1000.0;
  const auto other = made(Estimator::hv);
  for (std::size_t i = 0; i < hv.size(); ++i) EXPECT_LE(std::abs(1000.0 * other[i] - hv[i]), 1e-14 * std::abs(hv[i]));
}

TEST(Estimate, WithoutForceOrASecondBlowNothingIsMadeUp) {
  Spectra spectra = simulated(3, {1.0, 0.0, 0.01}, 0.0, 4);
  for (std::size_t h = 0; h < 3; ++h) spectra.force[h * lines + 1] = 0.0;
  const Estimate made = estimate(spectra, Estimator::hv, NoiseFrom::scatter, 3.0);
  EXPECT_TRUE(std::isnan(made.frf[responses].real()));
  EXPECT_TRUE(std::isnan(made.variance[responses].real()));
  EXPECT_FALSE(std::isnan(made.frf[0].real()));
  const Estimate one = estimate(simulated(1, {}, 0.0, 5), Estimator::h1, NoiseFrom::residuals, 1.0);
  EXPECT_FALSE(std::isnan(one.frf[0].real()));
  EXPECT_TRUE(std::isnan(one.variance[0].real()) && std::isnan(one.coherence[0]) && std::isnan(one.covariance[0].real()));
}

/// What 400 simulated tests of five blows scatter by, and what they say on average of themselves. Both are sums of some 400
/// products: the tolerance of five standard deviations is 0.25 of √(C_rr C_ss); real and imaginary part of E[e e] are zero to the
/// same.
void expect_stated(Estimator estimator, NoiseFrom from, const Noise& noise, double spread) {
  constexpr int trials = 400;
  const std::size_t pairs = frf::pair_count(responses);
  std::vector<std::vector<Complex>> frfs;
  std::vector<Complex> stated(lines * pairs), mean(lines * responses);
  for (int trial = 0; trial < trials; ++trial) {
    const Estimate made = estimate(simulated(5, noise, spread, 1000 + static_cast<std::uint64_t>(trial)), estimator, from, 5.0);
    for (std::size_t i = 0; i < stated.size(); ++i) stated[i] += made.covariance[i] / static_cast<double>(trials);
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += made.frf[i] / static_cast<double>(trials);
    frfs.push_back(made.frf);
  }
  for (std::size_t line = 0; line < lines; ++line) {
    const auto own = [&](std::size_t r) { return stated[line * pairs + frf::pair_index(r, r)].real(); };
    for (std::size_t r = 0; r < responses; ++r) {
      for (std::size_t s = 0; s <= r; ++s) {
        Complex sample = 0.0, pseudo = 0.0;
        for (const auto& frf : frfs) {
          const Complex a = frf[line * responses + r] - mean[line * responses + r],
                        b = frf[line * responses + s] - mean[line * responses + s];
          sample += a * std::conj(b) / (trials - 1.0);
          pseudo += a * b / (trials - 1.0);
        }
        const double tolerance = 0.25 * std::sqrt(own(r) * own(s));
        EXPECT_LE(std::abs(sample - stated[line * pairs + frf::pair_index(r, s)]), tolerance) << line << " " << r << " " << s;
        EXPECT_LE(std::abs(pseudo), tolerance) << line << " " << r << " " << s;
      }
    }
  }
}

TEST(Covariance, OfCommonHammerNoiseIsTheScatterOf400Tests) {
  for (const Estimator estimator : {Estimator::h1, Estimator::h2, Estimator::hv}) {
    for (const NoiseFrom from : {NoiseFrom::residuals, NoiseFrom::scatter})
      expect_stated(estimator, from, {3.0, 0.0, 0.001}, 0.0);
  }
}

TEST(Covariance, OfSharedAndOwnNoiseIsTheScatterOf400Tests) {
  expect_stated(Estimator::h1, NoiseFrom::residuals, {0.5, 0.003, 0.002}, 0.3);
  expect_stated(Estimator::h1, NoiseFrom::scatter, {0.5, 0.003, 0.002}, 0.3);
}

/// Common hammer noise alone: all errors are one, e_r = −H_r n.
TEST(Covariance, OfHammerNoiseAloneHasRankOne) {
  const Estimate made = estimate(simulated(5, {2.0, 0.0, 0.0}, 0.2, 6), Estimator::h1, NoiseFrom::residuals, 5.0);
  const auto c = [&](std::size_t r, std::size_t s) { return made.covariance[frf::pair_index(r, s)]; };
  EXPECT_GT(c(0, 0).real(), 0.0);
  EXPECT_NEAR(std::norm(c(1, 0)), c(0, 0).real() * c(1, 1).real(), 1e-9 * std::norm(c(1, 0)));
  EXPECT_NEAR(std::arg(c(1, 0)), std::arg(truth(1, 0) / truth(0, 0)), 0.2);
}

/// Overlapping Hann segments of a shaker: 100 tests whose motion has noise. Two errors of the FRF a line apart are correlated, so
/// the mean over lines of 100 tests is known to some 3 %.
TEST(Covariance, OfOverlappingSegmentsCountsWhatTheyAreWorth) {
  constexpr std::size_t samples = 2048, trials = 100;
  const auto record = [&](std::uint64_t trial) {
    Record out{
        "a",
        128.0,
        {{"f", frf::Dof::parse("1:+Z"), ChannelKind::force, {}}, {"x", frf::Dof::parse("2:+Z"), ChannelKind::displacement, {}}}};
    for (std::size_t t = 0; t < samples; ++t) {
      const auto pair = normal_numbers({31, trial}, t);
      out.channels[0].samples.push_back(pair[0]);
      out.channels[1].samples.push_back(2.0 * pair[0] + 0.5 * pair[1]);
    }
    return out;
  };
  FrfOptions options;
  for (const double overlap : {0.0, 0.5, 0.75}) {
    options.segments = {.block_s = 1.0, .overlap = overlap};
    double scatter = 0.0, stated = 0.0;
    for (std::uint64_t trial = 0; trial < trials; ++trial) {
      const MeasuredFrfs made = make_frfs(std::vector{record(trial)}, options);
      for (std::size_t line = 4; line + 4 < made.set.header.lines(); ++line) {
        scatter += std::norm(made.set.values[line] - 2.0);
        stated += made.set.variance[line].real() + made.set.variance[line].imag();
      }
    }
    EXPECT_NEAR(stated / scatter, 1.0, 0.12) << overlap;
  }
}

}  // namespace
}  // namespace jointid::records

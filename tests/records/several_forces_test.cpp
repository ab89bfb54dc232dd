#include "records/estimate/several_forces.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "base/error.hpp"
#include "base/random.hpp"
#include "frf/set/frf_set.hpp"
#include "records/estimate/measured_frfs.hpp"

namespace jointid::records {
namespace {

constexpr std::size_t two = 2;
constexpr std::array<std::array<double, two>, two> gains = {{{2.0, -0.5}, {0.3, 1.5}}};  // [response][force]

/// Two correlated random forces and two motions, with noise that both share.
Record two_shakers(std::size_t samples, double noise, std::uint64_t trial) {
  Record out{"a",
             256.0,
             {{"f", frf::Dof::parse("1:+Z"), ChannelKind::force},
              {"g", frf::Dof::parse("2:+Z"), ChannelKind::force},
              {"x", frf::Dof::parse("3:+Z"), ChannelKind::displacement},
              {"y", frf::Dof::parse("4:+Z"), ChannelKind::displacement}}};
  for (std::size_t t = 0; t < samples; ++t) {
    const auto a = normal_numbers({41, trial}, t), b = normal_numbers({42, trial}, t);
    const std::array f = {a[0], 10.0 * (a[1] + 0.5 * a[0])};
    out.channels[0].samples.push_back(f[0]);
    out.channels[1].samples.push_back(f[1]);
    for (std::size_t r = 0; r < two; ++r) {
      out.channels[2 + r].samples.push_back(gains[r][0] * f[0] + gains[r][1] * f[1] +
                                            noise * (b[0] + static_cast<double>(r) * b[1]));
    }
  }
  return out;
}

FrfOptions segments() {
  FrfOptions options;
  options.segments = {.block_s = 0.25, .overlap = 0.0};
  return options;
}

TEST(SeveralForces, AreToldApart) {
  const MeasuredFrfs made = make_frfs(std::vector{two_shakers(1024, 0.0, 1)}, segments());
  EXPECT_EQ(frf::names(made.set.header.reference), (std::vector<std::string>{"1:+Z", "2:+Z"}));
  EXPECT_EQ(made.averages[1].kept, 16u);
  for (std::size_t line = 0; line < made.set.header.lines(); ++line) {
    for (std::size_t r = 0; r < two; ++r) {
      for (std::size_t c = 0; c < two; ++c) {
        EXPECT_LE(std::abs(made.set.values[made.set.index(line, r, c)] - gains[r][c]), 1e-12);
        EXPECT_NEAR(made.coherence[made.set.index(line, r, c)], 1.0, 1e-13);
      }
    }
  }
}

/// One force is the plain H1.
TEST(SeveralForces, OfOneIsH1) {
  Spectra spectra{2, 2, 6, {}, {}};
  for (std::uint64_t i = 0; i < 12; ++i) spectra.force.emplace_back(normal_numbers({5, 0}, i)[0], normal_numbers({5, 0}, i)[1]);
  for (std::uint64_t i = 0; i < 24; ++i) spectra.motion.emplace_back(normal_numbers({6, 0}, i)[0], normal_numbers({6, 0}, i)[1]);
  const Estimate plain = estimate(spectra, Estimator::h1, NoiseFrom::residuals, 5.5);
  const Estimate general = estimate(SeveralForces{2, 1, 2, 6, spectra.force, spectra.motion}, 5.5).of_force.front();
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LE(std::abs(general.frf[i] - plain.frf[i]), 1e-13);
    EXPECT_NEAR(general.coherence[i], plain.coherence[i], 1e-13);
    EXPECT_LE(std::abs(general.variance[i] - plain.variance[i]), 1e-13);
  }
  for (std::size_t i = 0; i < 6; ++i) EXPECT_LE(std::abs(general.covariance[i] - plain.covariance[i]), 1e-13);
}

/// Over 150 tests and the lines, which are independent without overlap but for what the window mixes.
TEST(SeveralForces, StateTheirCovariances) {
  std::array<std::array<Complex, 3>, two> scatter{}, stated{};
  std::array<Complex, 4> between{}, stated_between{};  // [r, s] of the first force with the second
  for (std::uint64_t trial = 0; trial < 150; ++trial) {
    const MeasuredFrfs made = make_frfs(std::vector{two_shakers(512, 0.3, trial)}, segments());
    for (std::size_t line = 3; line + 3 < made.set.header.lines(); ++line) {
      const auto covariance = [&](std::size_t r, std::size_t s, std::size_t c) {
        const Complex value = made.set.covariance[(line * 3 + frf::pair_index(std::max(r, s), std::min(r, s))) * two + c];
        return r < s ? std::conj(value) : value;
      };
      const double larger = std::sqrt(covariance(0, 0, 1).real() / covariance(0, 0, 0).real());
      for (std::size_t i = 0; i < 4; ++i) {
        const auto error = [&](std::size_t r, std::size_t c) {
          return made.set.values[made.set.index(line, r, c)] - gains[r][c];
        };
        between[i] += error(i / two, 0) * std::conj(error(i % two, 1));
        stated_between[i] += made.set.reference_correlation[line * 4 + 1] * larger * covariance(i / two, i % two, 0);
      }
      for (std::size_t c = 0; c < two; ++c) {
        const auto error = [&](std::size_t r) { return made.set.values[made.set.index(line, r, c)] - gains[r][c]; };
        for (std::size_t r = 0; r < two; ++r) {
          for (std::size_t s = 0; s <= r; ++s) {
            scatter[c][frf::pair_index(r, s)] += error(r) * std::conj(error(s));
            stated[c][frf::pair_index(r, s)] += made.set.covariance[(line * 3 + frf::pair_index(r, s)) * two + c];
          }
        }
      }
    }
  }
  for (std::size_t c = 0; c < two; ++c) {
    for (std::size_t pair = 0; pair < 3; ++pair)
      EXPECT_LE(std::abs(scatter[c][pair] / stated[c][pair] - 1.0), 0.15) << c << " " << pair;
  }
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LE(std::abs(between[i] / stated_between[i] - 1.0), 0.15) << i;
}

TEST(SeveralForces, ThatAreOneGiveNothing) {
  Record record = two_shakers(1024, 0.1, 1);
  for (std::size_t t = 0; t < 1024; ++t) record.channels[1].samples[t] = 3.0 * record.channels[0].samples[t];
  const MeasuredFrfs made = make_frfs(std::vector{record}, segments());
  EXPECT_TRUE(std::isnan(made.set.values[5].real()));
}

TEST(SeveralForces, AskForSegmentsAndH1) {
  EXPECT_THROW(make_frfs(std::vector{two_shakers(512, 0.1, 1)}, {}), InputError);
  FrfOptions options = segments();
  options.estimator = Estimator::hv;
  EXPECT_THROW(make_frfs(std::vector{two_shakers(512, 0.1, 1)}, options), InputError);
  Record other = two_shakers(512, 0.1, 1);
  other.channels[1].dof.node = 9;
  EXPECT_THROW(make_frfs(std::vector{two_shakers(512, 0.1, 1), other}, segments()), InputError);
}

}  // namespace
}  // namespace jointid::records

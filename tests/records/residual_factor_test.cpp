// Covariances of few blows as a factor: what a plain sum over the blows says.
#include "records/estimate/residual_factor.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "base/random.hpp"
#include "frf/set/frf_source.hpp"
#include "records/estimate/measured_frfs.hpp"
#include "records/estimate/several_forces.hpp"

namespace jointid::records {
namespace {

std::vector<Complex> random_numbers(std::size_t count, std::uint64_t seed, std::uint64_t what) {
  std::vector<Complex> out;
  for (std::size_t i = 0; i < count; ++i) {
    const auto pair = normal_numbers({seed, what}, i);
    out.emplace_back(pair[0], pair[1]);
  }
  return out;
}

/// Largest difference of L Lᴴ from the pairs, in parts of √(C_rr C_ss).
double difference(const Estimate& factored, const Estimate& paired, std::size_t lines, std::size_t responses) {
  const std::size_t rank = factored.factor.size() / (lines * responses), pairs = frf::pair_count(responses);
  double largest = 0.0;
  for (std::size_t line = 0; line < lines; ++line) {
    const auto pair = [&](std::size_t r, std::size_t s) { return paired.covariance[line * pairs + frf::pair_index(r, s)]; };
    for (std::size_t r = 0; r < responses; ++r) {
      for (std::size_t s = 0; s <= r; ++s) {
        Complex sum = 0.0;
        for (std::size_t k = 0; k < rank; ++k) {
          sum += factored.factor[(line * responses + r) * rank + k] * std::conj(factored.factor[(line * responses + s) * rank + k]);
        }
        largest = std::max(largest, std::abs(sum - pair(r, s)) / std::sqrt(pair(r, r).real() * pair(s, s).real()));
      }
    }
  }
  return largest;
}

RC_GTEST_PROP(ResidualFactor, IsThePlainSumOverTheBlows, ()) {
  const auto count = *rc::gen::inRange<std::size_t>(2, 9), responses = *rc::gen::inRange<std::size_t>(1, 6);
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const auto estimator = *rc::gen::element(Estimator::h1, Estimator::h2, Estimator::hv);
  const auto noise = *rc::gen::element(NoiseFrom::residuals, NoiseFrom::scatter);
  constexpr std::size_t lines = 2;
  const Spectra spectra{lines, responses, count, random_numbers(count * lines, seed, 1),
                        random_numbers(count * responses * lines, seed, 2)};
  const auto made = [&](CovarianceForm form) { return estimate(spectra, estimator, noise, 1.7, form); };
  const Estimate factored = made(CovarianceForm::factor), paired = made(CovarianceForm::pairs);
  RC_ASSERT(factored.covariance.empty());
  RC_ASSERT(factored.factor.size() == lines * responses * factor_rank(count, estimator, noise));
  RC_ASSERT(factored.variance == paired.variance);
  RC_ASSERT(difference(factored, paired, lines, responses) < 1e-11);
}

RC_GTEST_PROP(ResidualFactor, OfSeveralForcesIsThePlainSumOverTheSegments, ()) {
  const auto forces = *rc::gen::inRange<std::size_t>(1, 4), responses = *rc::gen::inRange<std::size_t>(1, 6);
  const auto count = forces + *rc::gen::inRange<std::size_t>(1, 6);
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  constexpr std::size_t lines = 2;
  const SeveralForces spectra{lines, forces, responses, count, random_numbers(count * forces * lines, seed, 1),
                              random_numbers(count * responses * lines, seed, 2)};
  const double effective = static_cast<double>(forces) + 0.5;
  const SeveralEstimates factored = estimate(spectra, effective, CovarianceForm::factor), paired = estimate(spectra, effective);
  for (std::size_t c = 0; c < forces; ++c) {
    RC_ASSERT(factored.of_force[c].factor.size() == lines * responses * (count - forces));
    RC_ASSERT(difference(factored.of_force[c], paired.of_force[c], lines, responses) < 1e-9);
  }
}

/// Zero directions of one blow, and errors that are not finite.
TEST(ResidualFactor, OfWhatIsNotFiniteIsNotKnown) {
  Eigen::MatrixXcd errors(2, 3), direction(1, 3);
  errors << 1.0, -1.0, 0.0, HUGE_VAL, 0.0, 1.0;
  direction << 0.0, 0.0, 2.0;
  const Eigen::MatrixXcd factor = residual_factor(errors, direction);
  EXPECT_EQ(factor.cols(), 2);
  EXPECT_NEAR(factor.row(0).squaredNorm(), 2.0, 1e-14);
  EXPECT_TRUE(std::isnan(factor(1, 0).real()) && std::isnan(factor(1, 1).imag()));
}

/// Blows on `responses` points, as records.
std::vector<Record> hammer_blows(std::size_t count, std::size_t responses, std::size_t forces) {
  std::vector<Record> out;
  for (std::size_t h = 0; h < count; ++h) {
    Record record{"blow", 64.0, {}};
    for (std::size_t f = 0; f < forces; ++f) {
      record.channels.push_back({"f" + std::to_string(f), frf::Dof::parse(std::to_string(91 + f) + ":+Z"), ChannelKind::force});
    }
    for (std::size_t r = 0; r < responses; ++r) {
      record.channels.push_back({"x" + std::to_string(r), frf::Dof::parse(std::to_string(r + 1) + ":+Z"), ChannelKind::acceleration});
    }
    for (std::size_t t = 0; t < 32; ++t) {
      for (std::size_t i = 0; i < record.channels.size(); ++i) {
        const double noise = normal_numbers({7, h * 100 + i}, t)[0];
        const double pulse = t == 3 ? 10.0 + static_cast<double>(h) : 0.0;
        record.channels[i].samples.push_back(i < forces ? (forces > 1 ? noise : pulse)
                                                        : 0.1 * static_cast<double>(i) * pulse + 0.01 * noise);
      }
    }
    out.push_back(std::move(record));
  }
  return out;
}

/// Eight responses or more to five blows; the others, and what an exponential window mixes, stay pairs.
TEST(MeasuredFrfs, TellTheirCovariancesInTheSmallerForm) {
  const MeasuredFrfs many = make_frfs(hammer_blows(5, 8, 1), {}), few = make_frfs(hammer_blows(5, 7, 1), {});
  EXPECT_EQ(many.set.factor.rank, 4u);
  EXPECT_TRUE(many.set.covariance.empty());
  frf::validate(many.set);
  EXPECT_FALSE(few.set.factor.any());
  FrfOptions window;
  window.decay_time_s = 0.1;
  EXPECT_FALSE(make_frfs(hammer_blows(5, 8, 1), window).set.factor.any());
  FrfOptions segments;
  segments.segments = {.block_s = 0.5, .overlap = 0.0};
  const MeasuredFrfs shaken = make_frfs(hammer_blows(5, 9, 2), segments);
  EXPECT_EQ(shaken.set.factor.rank, 3u);
  // The diagonal is the sum of the variances of both parts, but for 0 Hz, where an accelerance fixes no receptance.
  for (const MeasuredFrfs* made : {&many, &shaken}) {
    const frf::FrfSet& set = made->set;
    const std::size_t rows = set.header.response.size(), columns = set.header.reference.size();
    const std::vector<Complex> pairs = frf::covariance_pairs(set);
    for (std::size_t i = rows * columns; i < set.values.size(); ++i) {
      const std::size_t line = i / (rows * columns), r = i / columns % rows;
      const double own = pairs[(line * frf::pair_count(rows) + frf::pair_index(r, r)) * columns + i % columns].real();
      EXPECT_NEAR(own, set.variance[i].real() + set.variance[i].imag(), 1e-12 * own);
    }
  }
}

}  // namespace
}  // namespace jointid::records

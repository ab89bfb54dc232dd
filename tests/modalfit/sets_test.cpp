#include <gtest/gtest.h>

#include <cmath>

#include "modalfit/fit.hpp"
#include "problems/case/modal_set.hpp"

namespace jointid::modalfit {
namespace {

/// Sums over seeds of squared errors and of the bound's variances, per mode.
struct Squares {
  std::vector<double> frequency, damping, frequency_bound, damping_bound;
  explicit Squares(std::size_t n) : frequency(n), damping(n), frequency_bound(n), damping_bound(n) {}
};

double ratio(const std::vector<double>& squares, const std::vector<double>& bound) {
  double worst = 0.0;
  for (std::size_t r = 0; r < squares.size(); ++r) worst = std::max(worst, std::sqrt(squares[r] / bound[r]));
  return worst;
}

/// Every seed: all modes and no other, frequencies within 1e-4, damping within 3 %; over the seeds: rms errors within 1.3 times the
/// Cramér–Rao bound.
void expect_accurate(const std::string& name, std::uint64_t seeds) {
  const auto set = problems::make_modal_set(name);
  const std::size_t n = set.modes.count();
  Squares sums(n);
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const frf::FrfSet noisy = problems::polluted(set, seed, 0);
    Band band = make_band(noisy, {});
    const ModalFit found = fit(band, noisy.header, {.kind = {Damping::hysteretic, true}});
    ASSERT_EQ(found.modes.size(), n) << name << " seed " << seed;
    ASSERT_EQ(found.status, FitStatus::ok) << name << " seed " << seed;
    for (std::size_t r = 0; r < n; ++r) {
      const Mode& mode = found.modes[r];
      const double f = mode.pole.frequency_hz - set.modes.frequency_hz[r], d = mode.pole.damping - set.modes.loss_factor[r];
      EXPECT_LE(std::abs(f), 1e-4 * set.modes.frequency_hz[r]);
      EXPECT_LE(std::abs(d), 0.03 * set.modes.loss_factor[r]);
      sums.frequency[r] += f * f;
      sums.damping[r] += d * d;
      sums.frequency_bound[r] += mode.frequency_deviation_hz * mode.frequency_deviation_hz;
      sums.damping_bound[r] += mode.damping_deviation * mode.damping_deviation;
    }
  }
  const double frequency = ratio(sums.frequency, sums.frequency_bound), damping = ratio(sums.damping, sums.damping_bound);
  testing::Test::RecordProperty("frequency_over_bound", std::to_string(frequency));
  testing::Test::RecordProperty("damping_over_bound", std::to_string(damping));
  std::printf("%s, %d seeds: worst rms error over bound: frequency %.3f, damping %.3f\n", name.c_str(), static_cast<int>(seeds), frequency,
              damping);
  EXPECT_LE(frequency, 1.3);
  EXPECT_LE(damping, 1.3);
}

TEST(ModalSets, ClosePairInAHundredSeeds) { expect_accurate("modes-pair", 100); }
TEST(ModalSets, ThirtyModesInAHundredSeeds) { expect_accurate("modes-30", 100); }

}  // namespace
}  // namespace jointid::modalfit

#include <gtest/gtest.h>

#include <cmath>

#include "modalfit/model/fit.hpp"
#include "problems/case/modal_set.hpp"

namespace jointid::modalfit {
namespace {

/// Every seed: all modes and no other, frequencies within 1e-4, damping within 3 %. Over seeds and modes together: rms of the
/// errors in parts of their Cramér–Rao bounds within `most`, and not below its inverse, for then the bound would be no bound.
void expect_accurate(const std::string& name, std::uint64_t seeds, double most) {
  const auto set = problems::make_modal_set(name);
  const std::size_t n = set.modes.count();
  double frequency = 0.0, damping = 0.0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const frf::FrfSet noisy = problems::polluted(set, seed, 0);
    Band band = make_band(noisy, {});
    const ModalFit found = fit(band, noisy.header, {.kind = {Damping::hysteretic, true}});
    ASSERT_EQ(found.modes.size(), n) << name << " seed " << seed;
    ASSERT_EQ(found.status, Status::ok) << name << " seed " << seed;
    for (std::size_t r = 0; r < n; ++r) {
      const Mode& mode = found.modes[r];
      const double f = mode.pole.frequency_hz - set.modes.frequency_hz[r], d = mode.pole.damping - set.modes.loss_factor[r];
      EXPECT_LE(std::abs(f), 1e-4 * set.modes.frequency_hz[r]);
      EXPECT_LE(std::abs(d), 0.03 * set.modes.loss_factor[r]);
      frequency += std::pow(f / mode.frequency_deviation_hz, 2);
      damping += std::pow(d / mode.damping_deviation, 2);
    }
  }
  for (const double sum : {frequency, damping}) {
    const double rms = std::sqrt(sum / static_cast<double>(seeds * n));
    std::printf("%s, %d seeds: rms error over bound %.3f\n", name.c_str(), static_cast<int>(seeds), rms);
    EXPECT_LE(rms, most);
    EXPECT_GE(rms, 1.0 / most);
  }
}

// About four standard deviations of an rms of n values, 1/√(2n). Mode by mode and in a hundred seeds: bench_modal_sets.
TEST(ModalSets, ClosePairInThirtySeeds) { expect_accurate("modes-pair", 30, 1.4); }
TEST(ModalSets, ThirtyModesInFourSeeds) { expect_accurate("modes-30", 4, 1.25); }

}  // namespace
}  // namespace jointid::modalfit

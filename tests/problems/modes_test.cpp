#include "problems/structure/modes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "problems/case/thesis_beams.hpp"

namespace jointid::problems {
namespace {

void expect_frequencies(const Modes& all, std::size_t rigid, const std::vector<double>& elastic_hz) {
  for (std::size_t r = 0; r < rigid; ++r) EXPECT_EQ(all.frequency_hz[r], 0.0);
  for (std::size_t i = 0; i < elastic_hz.size(); ++i)
    EXPECT_NEAR(all.frequency_hz[rigid + i], elastic_hz[i], 5e-4);
}

TEST(Modes, WorkedNaturalFrequencies) {
  const Case a1 = basic_case("A1", "");
  expect_frequencies(modes(a1.substructures[0]), 2, {79.974, 220.984, 484.705, 870.059, 1684.744, 2072.483});
  expect_frequencies(modes(a1.substructures[1]), 2, {179.848, 562.865, 1407.452, 2248.558});
  expect_frequencies(modes(a1.assembly), 2,
                     {22.615, 60.485, 120.668, 228.086, 294.871, 537.120, 672.146, 965.781});
}

TEST(Modes, ElasticModesHaveTheLossFactorOfTheBeam) {
  const Modes all = modes(basic_case("A1", "").assembly);
  for (std::size_t r = 0; r < all.count(); ++r) EXPECT_NEAR(all.loss_factor[r], r < 2 ? 0.0 : 0.001, 1e-9);
}

TEST(Modes, RigidBodyModesOfAFreePairAreZero) {
  const Modes all = modes(merged(substructure_a(), substructure_b()));
  EXPECT_EQ(std::count(all.frequency_hz.begin(), all.frequency_hz.end(), 0.0), 4);
}

TEST(Modes, TheSumOfAllModesIsTheInverse) {
  const Structure assembly = basic_case("A1", "").assembly;
  const ResponseRequest request{
      .response = assembly.dofs(), .reference = assembly.dofs(), .frequency_hz = {30.0, 455.0, 999.0}};
  const frf::FrfSet direct = frequency_response(assembly, request);
  const frf::FrfSet modal = modal_response(modes(assembly), request);
  for (std::size_t line = 0; line < 3; ++line) {
    const auto begin = direct.values.begin() + static_cast<std::ptrdiff_t>(line * 196);
    const double largest = std::abs(*std::max_element(
        begin, begin + 196, [](Complex a, Complex b) { return std::abs(a) < std::abs(b); }));
    for (std::size_t i = line * 196; i < (line + 1) * 196; ++i) {
      EXPECT_NEAR(std::abs(direct.values[i] - modal.values[i]), 0.0, 1e-9 * largest);
    }
  }
}

TEST(Modes, ConsistentErrorsStayWithinTheirBoundsAndSpread) {
  const Modes exact = modes(substructure_a());
  const Modes wrong = with_consistent_errors(exact, {}, {.seed = 3, .trial = 1, .set = 0});
  double largest = 0.0;
  for (std::size_t i = 0; i < exact.shapes.size(); ++i) {
    const double deviation = std::abs(wrong.shapes[i] / exact.shapes[i] - 1.0);
    EXPECT_LE(deviation, 0.05 + 1e-12);
    largest = std::max(largest, deviation);
  }
  EXPECT_GT(largest, 0.04);
  for (std::size_t r = 2; r < exact.count(); ++r) {
    EXPECT_LE(std::abs(wrong.frequency_hz[r] / exact.frequency_hz[r] - 1.0), 0.01 + 1e-12);
    EXPECT_LE(std::abs(wrong.loss_factor[r] / exact.loss_factor[r] - 1.0), 0.01 + 1e-12);
    EXPECT_NE(wrong.frequency_hz[r], exact.frequency_hz[r]);
  }
}

}  // namespace
}  // namespace jointid::problems

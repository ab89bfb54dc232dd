#include <gtest/gtest.h>

#include <algorithm>

#include "friction/curve/equivalent.hpp"
#include "friction/law/laws.hpp"
#include "rig_two_table.hpp"

namespace jointid::problems {
namespace {

double middle(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

/// Median over seeds and levels of |Δ(k + id)|/|k + id| at the four smallest displacements.
double small_error(const RigTwo& rig, Form form, std::uint64_t seeds) {
  const auto element = friction::make_element("ren", rig.element);
  std::vector<double> errors;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const friction::Curve found = equivalents(polluted(rig, seed), form);
    for (std::size_t i = 0; i < 4; ++i) {
      const friction::Equivalent exact = friction::equivalent(*element, found.u[i]);
      errors.push_back(std::hypot(found.value[i] - exact.stiffness, found.damping[i] - exact.damping) /
                       std::hypot(exact.stiffness, exact.damping));
    }
  }
  return middle(std::move(errors));
}

/// 200 seeds, and the other forms of the equations: bench_rig_two. 195 of 200 limits within 15 % there; of 40, five beyond are a
/// chance of 1 in 300 when that is the true share, and seeds are always the same.
TEST(RigTwoSeeds, TheLimitIsWithinFifteenPercentByTheRigidReference) {
  for (const ProblemInfo& info : list_rig_two()) {
    const RigTwo rig = make_rig_two(info.name);
    std::size_t within = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) within += std::abs(limit_ratio(polluted(rig, seed), {}) - 1.0) < 0.15;
    EXPECT_GE(within, 36u) << rig.name;
    EXPECT_LT(small_error(rig, {}, 20), 0.5 * small_error(rig, {.rigid = false, .real = true}, 20)) << rig.name;
  }
}

}  // namespace
}  // namespace jointid::problems

#include "friction/joint/distributed_slip.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <stdexcept>

#include "base/error.hpp"
#include "friction/path/masing_path.hpp"
#include "random_element.hpp"

namespace jointid::friction {
namespace {

/// Largest difference of algorithm A with `count` sliders to algorithm B along a history, over the force at its largest
/// displacement.
double difference(const Element& element, const std::vector<double>& history, std::size_t count) {
  double largest = 0.0, worst = 0.0;
  for (const double u : history) largest = std::max(largest, std::abs(u));
  DistributedSlip state(sliders(element, slip_knots(element, count, largest)));
  MasingPath path(element);
  for (const double u : history) worst = std::max(worst, std::abs(state.advance(u).force - path.advance(u).force));
  return worst / element.response(largest).force;
}

TEST(DistributedSlip, ConvergesToTheLawWithTheSquareOfTheSliders) {
  const std::vector<double> history = {3e-7, -2e-7, 2.3e-7, 1e-7, 2.9e-7, -6e-7, 5e-7, 4e-7};
  for (const auto& [law, values] : {std::pair<std::string, std::vector<double>>{"ren", {5e-8, 3.0, 1e6}},
                                    {"shoukry", {10.0, 5e6}},
                                    {"burdekin", {5e7, -5e13}},
                                    {"iwan", {10.0, 5e7, -0.5, 0.3}}}) {
    const auto element = make_element(law, values);
    const double coarse = difference(*element, history, 32), fine = difference(*element, history, 256);
    EXPECT_LT(fine, 1e-4) << law;
    EXPECT_GT(coarse / fine, 25.0) << law;  // 64 at order two
  }
}

RC_GTEST_PROP(DistributedSlip, OfABilinearAssemblyIsExact, ()) {
  Sliders parts;
  for (double slip = any_decade(1e-8, 1e-7), more = 6.0; more > 0.0; more -= 1.0, slip *= any_in(1.1, 3.0)) {
    parts.slip.push_back(slip);
    parts.stiffness.push_back(any_decade(1e6, 1e8));
  }
  const auto element = bilinear_assembly(parts);
  const Sliders again = sliders(*element, element->kinks());
  RC_ASSERT(again.slip.size() == parts.slip.size());
  for (std::size_t i = 0; i < parts.slip.size(); ++i) {
    RC_ASSERT(std::abs(again.stiffness[i] / parts.stiffness[i] - 1.0) < 1e-8);
  }
  RC_ASSERT(again.rest == 0.0);
}

// One slider under a normal load that doubles and falls again, by hand.
TEST(DistributedSlip, FollowsTheNormalLoad) {
  DistributedSlip state({.slip = {1.0}, .stiffness = {10.0}});
  EXPECT_DOUBLE_EQ(state.advance(0.5, 1.0).force, 5.0);
  EXPECT_DOUBLE_EQ(state.advance(3.0, 1.0).force, 10.0);
  EXPECT_DOUBLE_EQ(state.advance(3.5, 2.0).force, 15.0);   // sticks again
  EXPECT_DOUBLE_EQ(state.advance(5.0, 2.0).force, 20.0);   // and slips
  EXPECT_DOUBLE_EQ(state.advance(5.0, 0.5).force, 5.0);    // the load falls: slips where it is
  EXPECT_DOUBLE_EQ(state.advance(4.0, 0.5).force, -5.0);
  EXPECT_DOUBLE_EQ(state.advance(9.0, 0.0).force, 0.0);    // no contact
  EXPECT_DOUBLE_EQ(state.stored(), 0.0);
}

TEST(DistributedSlip, ScaledLoadIsALawWithScaledLimits) {
  const auto law = make_element("ren", std::array{5e-8, 3.0, 1e6}), half = make_element("ren", std::array{2.5e-8, 3.0, 1e6});
  DistributedSlip state(sliders(*law, slip_knots(*law, 400, 1e-6)));
  MasingPath path(*half);
  for (const double u : {3e-7, -2e-7, 5e-7}) {
    EXPECT_NEAR(state.advance(u, 0.5).force, path.advance(u).force, 1e-4 * half->limit());
  }
}

TEST(Sliders, WrongKnotsAreRefused) {
  const auto law = make_element("ren", std::array{5e-8, 3.0, 1e6});
  EXPECT_THROW(sliders(*law, std::vector<double>{}), InputError);
  EXPECT_THROW(sliders(*law, std::vector{0.0, 1e-7}), InputError);
  EXPECT_THROW(sliders(*law, std::vector{2e-7, 1e-7}), InputError);
}

}  // namespace
}  // namespace jointid::friction

#include "friction/path/record.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "base/error.hpp"
#include "friction/path/loops.hpp"

namespace jointid::friction {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::Pointwise;

/// `cycles` of u = mean − amplitude·cos and F = stiffness·u turned by `angle`, after a start from the middle.
Record ellipse(double cycles, double amplitude, double mean_u, double mean_f, double angle) {
  Record out;
  const std::size_t samples = static_cast<std::size_t>(std::lround(cycles * 400.0));
  for (std::size_t i = 0; i <= samples; ++i) {
    const double phase = 2.0 * std::numbers::pi * (static_cast<double>(i) / 400.0 + 0.25);
    out.displacement.push_back(mean_u - amplitude * std::cos(phase));
    out.force.push_back(mean_f - 5.0 * std::cos(phase + angle));
  }
  return out;
}

TEST(Record, LinearVelocityIsIntegratedExactlyOnUnevenSteps) {
  const std::vector<double> time = {0.0, 0.1, 0.4, 0.5, 1.5};
  std::vector<double> velocity, expected;
  for (const double t : time) {
    velocity.push_back(3.0 - 2.0 * t);
    expected.push_back(3.0 * t - t * t);
  }
  EXPECT_THAT(integrated(time, velocity), Pointwise(DoubleNear(1e-14), expected));
  EXPECT_THROW(integrated(std::vector{0.0, 0.0}, std::vector{1.0, 1.0}), InputError);
  EXPECT_THROW(integrated(std::vector{0.0}, std::vector{1.0, 1.0}), InputError);
}

TEST(Record, ElasticDeformationByStiffnessAndByCurveAgreeOnALine) {
  const Record record{{0.0, 1.0, 2.0, -2.0, 0.3}, {0.0, 10.0, 30.0, -30.0, -2.0}};
  const Record by_stiffness = without_elastic(record, 20.0);
  const Record by_curve = without_elastic(record, Record{{0.25, 0.5, 1.0}, {5.0, 10.0, 20.0}});
  EXPECT_THAT(by_curve.displacement, Pointwise(DoubleNear(1e-15), by_stiffness.displacement));
  EXPECT_THAT(by_stiffness.displacement, ElementsAre(0.0, 0.5, 0.5, -0.5, DoubleNear(0.4, 1e-15)));
  EXPECT_EQ(by_curve.force, record.force);
}

TEST(Record, ACurvedSpecimenIsInterpolatedAndContinued) {
  const Record specimen{{0.0, -1.0, -3.0}, {0.0, -10.0, -20.0}};
  const Record out = without_elastic(Record{{0.0, 0.0, 0.0, 0.0}, {5.0, 15.0, 30.0, -30.0}}, specimen);
  EXPECT_THAT(out.displacement, ElementsAre(-0.5, -2.0, -5.0, 5.0));
  EXPECT_THROW(without_elastic(Record{{0.0}, {1.0}}, Record{{1.0, 2.0}, {3.0, 3.0}}), InputError);
  EXPECT_THROW(without_elastic(Record{{0.0}, {1.0}}, Record{{1.0}, {0.0}}), InputError);
  EXPECT_THROW(without_elastic(Record{{0.0}, {1.0}}, -1.0), InputError);
}

TEST(Record, WorkOfAnEllipseIsItsArea) {
  const Record one = ellipse(1.0, 2.0, 7.0, -3.0, 0.3);
  EXPECT_NEAR(work(one), std::numbers::pi * 2.0 * 5.0 * std::sin(0.3), 1e-3 * work(one));
  EXPECT_DOUBLE_EQ(work(with_force_times(one, -1.0)), -work(one));
}

TEST(Record, SamplesThatAreNotFiniteAreLeftOut) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Record out = finite_samples({{0.0, nan, 2.0, 3.0}, {0.0, 1.0, nan, 4.0}});
  EXPECT_THAT(out.displacement, ElementsAre(0.0, 3.0));
  EXPECT_THAT(out.force, ElementsAre(0.0, 4.0));
}

TEST(Loops, ReversalsAreExtremesOfMovementsThatAreLargeEnough) {
  const std::vector<double> u = {0.0, 1.0, 0.9, 1.1, 3.0, 3.0, 2.8, 3.05, 0.2, 0.0, 0.4, -0.1, 2.0, 1.9};
  EXPECT_THAT(reversals(u, 1.0), ElementsAre(7u, 11u));
  EXPECT_THAT(reversals(u, 0.3), ElementsAre(7u, 9u, 10u, 11u));
  EXPECT_TRUE(reversals(u, 5.0).empty());
  EXPECT_TRUE(reversals({}, 1.0).empty());
}

TEST(Loops, WholeCyclesAreCutFromTheFirstReversalOn) {
  const Record record = ellipse(5.6, 2.0, 7.0, -3.0, 0.3);  // upper reversal first
  std::vector<Loop> found = loops(record, 1.0);
  ASSERT_EQ(found.size(), 5u);
  Record mirrored = with_force_times(record, -1.0);
  for (double& u : mirrored.displacement) u = 14.0 - u;
  for (Loop loop : loops(mirrored, 1.0)) {  // lower reversal first
    loop.record = with_force_times(loop.record, -1.0);
    EXPECT_NEAR(-centre(loop).force, 3.0, 1e-12);
    EXPECT_NEAR(loop.energy(), -found.front().energy(), 1e-9);
  }
  for (const Loop& loop : found) {
    EXPECT_EQ(loop.record.displacement.size(), 401u);
    EXPECT_EQ(loop.turn, 200u);
    EXPECT_NEAR(loop.amplitude(), 2.0, 1e-12);
    EXPECT_NEAR(loop.energy(), std::numbers::pi * 10.0 * std::sin(0.3), 1e-3 * loop.energy());
    EXPECT_NEAR(centre(loop).displacement, 7.0, 1e-12);
    EXPECT_NEAR(centre(loop).force, -3.0, 1e-12);
  }
}

TEST(Loops, TheCentreDoesNotDependOnDwellAtAnEnd) {
  Loop loop = loops(ellipse(2.5, 2.0, 7.0, -3.0, 0.3), 1.0).front();
  const LoopCentre before = centre(loop);
  Record& record = loop.record;
  const auto turn = static_cast<std::ptrdiff_t>(loop.turn);
  record.displacement.insert(record.displacement.begin() + turn, 1000, record.displacement[loop.turn]);
  record.force.insert(record.force.begin() + turn, 1000, record.force[loop.turn] - 0.5);
  EXPECT_NEAR(centre(loop).force, before.force, 1e-3);
  EXPECT_NEAR(centre(loop).displacement, before.displacement, 1e-12);
  const Loop moved = centred(loop);
  EXPECT_NEAR(centre(moved).force, 0.0, 1e-12);
  EXPECT_NEAR(moved.record.displacement.front(), -2.0, 1e-9);
}

TEST(Loops, MasingCurveOfBothBranchesIsTheSameForASymmetricLoop) {
  const Loop loop = centred(loops(ellipse(2.6, 2.0, 7.0, -3.0, 0.3), 1.0).front());
  const Record curve = masing_curve(loop);
  for (std::size_t i = 1; i <= 200; ++i) {
    EXPECT_NEAR(curve.displacement[i], curve.displacement[200 + i], 1e-9);
    EXPECT_NEAR(curve.force[i], curve.force[200 + i], 1e-9);
  }
  EXPECT_NEAR(curve.displacement[200], 2.0, 1e-9);
}

}  // namespace
}  // namespace jointid::friction

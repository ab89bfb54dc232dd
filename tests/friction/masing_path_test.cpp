#include "friction/path/masing_path.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <numbers>

#include "friction/joint/distributed_slip.hpp"
#include "friction/path/path_energy.hpp"
#include "friction/path/quadrature.hpp"
#include "random_element.hpp"

namespace jointid::friction {
namespace {

bool near(double value, double expected, double tolerance) {
  if (std::abs(value - expected) <= tolerance) return true;
  RC_LOG() << value << " instead of " << expected << ", difference / tolerance "
           << std::abs(value - expected) / tolerance << '\n';
  return false;
}

Sliders any_sliders() {
  Sliders sliders;
  for (std::size_t more = 1 + any_of(12); more > 0; --more) {
    sliders.slip.push_back(any_decade(1e-8, 1e-6));
    sliders.stiffness.push_back(any_decade(1e6, 1e8));
  }
  if (any_of(2) == 0) sliders.rest = any_decade(1e6, 1e7);
  return sliders;
}

/// Angles of x = u cos θ, 0 ≤ θ ≤ π, where the unloading from u is not analytic.
std::vector<double> events(const Element& element, double u) {
  std::vector<double> angles = {0.0};
  for (const double kink : element.kinks()) {
    if (kink < u) angles.push_back(std::acos(1.0 - 2.0 * kink / u));
  }
  angles.push_back(std::numbers::pi);
  return angles;
}

// The sliders know nothing of Masing's rule: each has its own state.
RC_GTEST_PROP(MasingPath, IsThatOfEverySliderForItself, ()) {
  const Sliders parts = any_sliders();
  const auto element = bilinear_assembly(parts);
  PathEnergy path(*element);
  DistributedSlip direct(parts);
  double largest = 0.0, energy = 0.0;
  for (const double u : any_history(*element)) {
    const Response masing = path.advance(u), each = direct.advance(u);
    largest = std::max(largest, std::abs(u));
    const double scale = element->response(largest).force;
    RC_ASSERT(near(masing.force, each.force, 1e-13 * scale));
    energy = std::max(energy, path.work());
    RC_ASSERT(near(path.stored(), direct.stored(), 1e-12 * energy));
    RC_ASSERT(near(path.loss(), direct.loss(), 1e-12 * energy));
  }
}

RC_GTEST_PROP(MasingPath, TurnsIntoTheFourierIntegrals, ()) {
  const auto element = any_element();
  const double u = any_displacement(*element);
  const std::vector<double> angles = events(*element, u);
  MasingPath path(*element);
  double in_phase = 0.0, out_of_phase = 0.0;
  for (const double sign : {1.0, -1.0}) {
    path.advance(sign * u);
    // Of each half cycle F − F(turn) = −sign·2T(u(1 − cos θ)/2); the constant gives no cosine, but a sine.
    const auto force = [&](double angle) { return path.response(sign * u * std::cos(angle)).force; };
    in_phase += integrate([&](double angle) { return sign * force(angle) * std::cos(angle); }, angles);
    out_of_phase -= integrate([&](double angle) { return sign * force(angle) * std::sin(angle); }, angles);
  }
  const double scale = element->response(u).force / u;
  RC_LOG() << describe(*element) << u << '\n';
  RC_ASSERT(near(in_phase / (std::numbers::pi * u), element->equivalent_stiffness(u), 1e-10 * scale));
  RC_ASSERT(near(out_of_phase / (std::numbers::pi * u), element->cycle_energy(u) / (std::numbers::pi * u * u), 1e-10 * scale));
}

RC_GTEST_PROP(MasingPath, WorkIsTheIntegralOfTheForce, ()) {
  const auto element = any_element(1);
  PathEnergy path(*element);
  double work = 0.0, most = 0.0;
  for (const double u : any_history(*element)) {
    // Between two displacements the force is smooth but at closures and at kinks behind the corners.
    while (path.path().displacement() != u) {
      const double from = path.path().displacement();
      const int direction = u > from ? 1 : -1;
      const Branch branch = path.path().branch(direction);
      const double to = direction * (u - branch.closure) > 0.0 ? branch.closure : u;
      std::vector<double> ends = {0.0};
      for (const double kink : element->kinks()) {
        const double at = branch.initial ? direction * kink : branch.corner.displacement + 2.0 * direction * kink;
        const double way = direction * (at - from);
        if (way > 0.0 && way < direction * (to - from)) ends.push_back(way);
      }
      ends.push_back(direction * (to - from));
      work += direction * integrate([&](double way) { return path.path().response(from + direction * way).force; }, ends);
      path.advance(to);
    }
    most = std::max(most, std::abs(work));
    RC_ASSERT(near(path.work(), work, 1e-10 * most));
    RC_ASSERT(path.loss() >= -1e-12 * most);
    RC_ASSERT(path.stored() >= -1e-12 * most);
  }
}

RC_GTEST_PROP(MasingPath, LossIsNeverNegativeOnAnyStep, ()) {
  const auto element = any_element();
  PathEnergy path(*element);
  for (const double u : any_history(*element)) {
    const double before = path.loss(), scale = path.work();
    path.advance(u);
    RC_ASSERT(path.loss() >= before - 1e-12 * (scale + path.work()));
  }
}

RC_GTEST_PROP(MasingPath, DoesNotDependOnTheSteps, ()) {
  const auto element = any_element();
  MasingPath coarse(*element), fine(*element);
  double last = 0.0, largest = 0.0;
  for (const double u : any_history(*element)) {
    const std::size_t steps = 1 + any_of(5);
    for (std::size_t i = 1; i < steps; ++i) {
      fine.advance(last + (u - last) * static_cast<double>(i) / static_cast<double>(steps));
    }
    const double force = fine.advance(u).force;
    largest = std::max(largest, std::abs(u));
    RC_ASSERT(near(coarse.advance(u).force, force, 1e-12 * element->response(largest).force));
    RC_ASSERT(coarse.corners().size() == fine.corners().size());
    last = u;
  }
}

RC_GTEST_PROP(MasingPath, ForgetsAClosedLoop, ()) {
  const auto element = any_element();
  MasingPath path(*element), without(*element);
  double largest = 0.0;
  for (const double u : any_history(*element)) {
    largest = std::max(largest, std::abs(u));
    path.advance(u);
    without.advance(u);
  }
  const double top = path.displacement();
  const int direction = path.direction();
  const double bottom = top + any_in(0.0, 1.0) * (path.branch(direction).corner.displacement - top);
  path.advance(bottom);
  path.advance(0.5 * (top + bottom));
  path.advance(bottom);
  path.advance(top);
  const double beyond = top + direction * any_displacement(*element);
  RC_ASSERT(path.corners().size() == without.corners().size() || bottom == top);
  const double scale = element->response(std::max(largest, std::abs(beyond))).force;
  RC_ASSERT(near(path.force(), without.force(), 1e-12 * scale));
  RC_ASSERT(near(path.advance(beyond).force, without.advance(beyond).force, 1e-12 * scale));
}

TEST(MasingPath, LeavesTheInitialCurveAndJoinsItAgain) {
  const auto element = make_element("ren", std::array{1e-7, 2.0, 1e7});
  MasingPath path(*element);
  path.advance(4e-7);
  path.advance(-3e-7);
  EXPECT_EQ(path.corners().size(), 1U);
  path.advance(2e-7);
  EXPECT_EQ(path.corners().size(), 2U);
  path.advance(-5e-7);
  EXPECT_TRUE(path.corners().empty());
  EXPECT_DOUBLE_EQ(path.force(), -element->response(5e-7).force);
  EXPECT_EQ(path.branch(-1).closure, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(path.branch(1).closure, 5e-7);
}

TEST(MasingPath, LookingAheadLeavesItWhereItIs) {
  const auto element = make_element("shoukry", std::array{10.0, 5e6});
  MasingPath path(*element);
  path.advance(3e-7);
  const double ahead = path.response(-1e-7).force;
  EXPECT_EQ(path.displacement(), 3e-7);
  EXPECT_EQ(path.advance(-1e-7).force, ahead);
}

TEST(MasingPath, TangentIsItsSlope) {
  const auto element = make_element("ren", std::array{1e-7, 2.0, 1e7});
  MasingPath path(*element);
  for (const double u : {4e-7, -3e-7, 2e-7}) path.advance(u);
  const double at = 0.7e-7, step = 1e-11;
  const double slope = (path.response(at + step).force - path.response(at - step).force) / (2.0 * step);
  EXPECT_NEAR(path.response(at).tangent, slope, 1e-5 * slope);
}

}  // namespace
}  // namespace jointid::friction

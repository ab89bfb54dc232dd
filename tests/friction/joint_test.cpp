#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <numbers>
#include <stdexcept>

#include "friction/law/bending_root.hpp"
#include "base/error.hpp"
#include "friction/law/menq_bar.hpp"
#include "friction/path/quadrature.hpp"
#include "friction/path/ring.hpp"
#include "friction/path/scaled.hpp"
#include "random_element.hpp"

namespace jointid::friction {
namespace {

constexpr double pi = std::numbers::pi;

bool near(double value, double expected, double relative) {
  if (std::abs(value - expected) <= relative * std::abs(expected)) return true;
  RC_LOG() << value << " instead of " << expected << ", relative " << value / expected - 1.0 << '\n';
  return false;
}

// Closed forms as printed, in more digits.

long double printed_ren(long double a, long double b, long double k, long double r1, long double r2, long double angle) {
  const long double ra = std::min(r2, std::max(r1, a / angle)), rb = std::min(r2, std::max(r1, a * std::exp(b) / angle));
  const auto elastic = [&](long double r) { return r * r * r * r; };
  const auto micro = [&](long double r) {
    return pi * k * angle * r * r * r * r * (5.0L / (8.0L * b) + 0.5L + std::log(a / (r * angle)) / (2.0L * b)) -
           2.0L * pi * k * a * r * r * r / (3.0L * b);
  };
  return pi * k * angle * (elastic(ra) - elastic(r1)) / 2.0L + micro(rb) - micro(ra) +
         2.0L * pi * k * a * (std::exp(b) - 1.0L) / (3.0L * b) * (r2 * r2 * r2 - rb * rb * rb);
}

long double printed_shoukry(long double a, long double b, long double r1, long double r2, long double angle) {
  const auto inner = [&](long double r) {
    const long double c = b * angle, e = std::exp(-c * r);
    return r * r * r / 3.0L + r * r * e / c + 2.0L * r * e / (c * c) + 2.0L * e / (c * c * c);
  };
  return 2.0L * pi * a * (inner(r2) - inner(r1));
}

long double printed_burdekin(long double a, long double b, long double r1, long double r2, long double angle) {
  const long double r0 = std::min(r2, std::max(r1, -a / (2.0L * angle * b)));
  const auto power = [](long double r, int n) { return std::pow(r, n); };
  return 2.0L * pi * b * angle * angle * (power(r0, 5) - power(r1, 5)) / 5.0L +
         pi * a * angle * (power(r0, 4) - power(r1, 4)) / 2.0L - pi * a * a * (power(r2, 3) - power(r0, 3)) / (6.0L * b);
}

RC_GTEST_PROP(Ring, TorqueIsThePrintedFormula, ()) {
  const double outer = any_in(0.01, 0.1), inner = outer * any_in(0.1, 0.8), slip = any_decade(1e-8, 1e-6);
  const double angle = slip / outer * any_decade(0.1, 30.0), k = any_decade(1e11, 1e13), spread = any_in(0.5, 6.0);
  const Ring ren(make_element("ren", std::array{slip, spread, k}), inner, outer);
  RC_ASSERT(near(ren.response(angle).force, static_cast<double>(printed_ren(slip, spread, k, inner, outer, angle)), 1e-12));
  const Ring shoukry(make_element("shoukry", std::array{k * slip, 1.0 / slip}), inner, outer);
  RC_ASSERT(near(shoukry.response(angle).force,
                 static_cast<double>(printed_shoukry(k * slip, 1.0 / slip, inner, outer, angle)), 1e-12));
  const Ring burdekin(make_element("burdekin", std::array{k, -0.5 * k / slip}), inner, outer);
  RC_ASSERT(near(burdekin.response(angle).force,
                 static_cast<double>(printed_burdekin(k, -0.5 * k / slip, inner, outer, angle)), 1e-12));
}

TEST(Ring, OfASpringIsAPolarMoment) {
  const Ring ring(make_element("spring", std::array{3e11}), 0.02, 0.04);
  const double expected = 0.5 * pi * 3e11 * (std::pow(0.04, 4) - std::pow(0.02, 4));
  EXPECT_NEAR(ring.response(0.0).tangent, expected, 1e-9 * expected);
  EXPECT_NEAR(ring.response(1e-5).tangent, expected, 1e-9 * expected);
  EXPECT_EQ(ring.parameters()[0].unit, "N/m^3");
}

std::unique_ptr<Element> any_joint() {
  switch (any_of(3)) {
    case 0: {
      const double outer = any_in(0.01, 0.1);
      return std::make_unique<Ring>(any_single(), outer * any_in(0.05, 0.9), outer);
    }
    case 1: {
      const double length = any_in(0.05, 1.0), spring = any_of(2) == 0 ? 0.0 : any_decade(1e6, 1e9);
      return std::make_unique<MenqBar>(MenqBar::Values{any_decade(1e6, 1e8), length, any_decade(1e8, 1e11), any_decade(1e2, 1e4), spring});
    }
    default:
      return std::make_unique<BendingRoot>(any_decade(1.0, 1e4), any_decade(1e2, 1e5), any_decade(0.01, 1.0));
  }
}

double any_amplitude(const Element& joint) {
  if (const auto* root = dynamic_cast<const BendingRoot*>(&joint)) return root->displacement(root->values()[1] * any_decade(1e-3, 1.0));
  return any_displacement(joint);
}

RC_GTEST_PROP(Joint, TangentEnergyAndLossFollowFromTheForce, ()) {
  const auto joint = any_joint();
  const double u = any_amplitude(*joint), step = 1e-4 * u;
  std::vector<double> ends = {0.0};
  for (const double kink : joint->kinks()) {
    RC_PRE(std::abs(u - kink) > 2.0 * step);
    if (kink < u) ends.push_back(kink);
  }
  ends.push_back(u);
  const auto force = [&](double v) { return joint->response(v).force; };
  const double slope = (8.0 * (force(u + step) - force(u - step)) - (force(u + 2 * step) - force(u - 2 * step))) / (12.0 * step);
  RC_ASSERT(std::abs(slope - joint->response(u).tangent) <= 1e-7 * force(u) / u);
  RC_ASSERT(near(joint->energy(u), integrate(force, ends), 1e-10));
  RC_ASSERT(std::abs(joint->cycle_energy(u) - joint->Element::cycle_energy(u)) <= 1e-11 * joint->energy(u));
  const double back = joint->displacement(force(u));
  if (std::isfinite(back)) RC_ASSERT(near(force(back), force(u), 1e-13));
}

RC_GTEST_PROP(Joint, DerivativesByParameters, ()) {
  const auto joint = any_joint();
  const double u = any_amplitude(*joint);
  const std::vector<double> values = joint->values();
  std::vector<double> derivative(values.size());
  joint->derivative(u, derivative);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] == 0.0) continue;
    const double step = 1e-4 * std::abs(values[i]);
    const auto shifted = [&](double times) {
      std::vector<double> other = values;
      other[i] += times * step;
      const auto changed = joint->with(other);
      const std::vector<double> before = joint->kinks(), after = changed->kinks();
      RC_PRE(before.size() == after.size());
      for (std::size_t j = 0; j < after.size(); ++j) RC_PRE((after[j] < u) == (before[j] < u));
      return changed->response(u).force;
    };
    const double slope = (8.0 * (shifted(1) - shifted(-1)) - (shifted(2) - shifted(-2))) / (12.0 * step);
    RC_ASSERT(std::abs(slope - derivative[i]) <= 1e-6 * joint->response(u).force / std::abs(values[i]));
  }
}

// Menq's bar of docs/formulas.md §10e for a free far end.
RC_GTEST_PROP(MenqBar, WithoutSpringIsTheClosedFormula, ()) {
  const double ea = any_decade(1e6, 1e8), length = any_in(0.05, 1.0), k = any_decade(1e8, 1e11), tau = any_decade(1e2, 1e4);
  const MenqBar bar({ea, length, k, tau, 0.0});
  const double s = length * any_in(0.0, 1.0), lambda = std::sqrt(k / ea);
  const double force = ea * lambda * tau / k * std::tanh(lambda * (length - s)) + tau * s;
  const double u = tau / k + (force - tau * s) * s / ea + tau * s * s / (2.0 * ea);
  RC_ASSERT(near(bar.response(u).force, force, 1e-12));
  RC_ASSERT(std::abs(bar.slipped_length(u) - s) <= 1e-6 * length);
  RC_ASSERT(near(bar.limit(), tau * length, 1e-15));
}

TEST(MenqBar, SlipsAgainstItsEndSpring) {
  const MenqBar bar({2e7, 0.5, 1e10, 1e4, 3e7});
  const double last = bar.kinks().back();
  EXPECT_TRUE(std::isinf(bar.limit()));
  EXPECT_NEAR(bar.response(2.0 * last).tangent, 1.0 / (1.0 / 3e7 + 0.5 / 2e7), 1.0);
  EXPECT_NEAR(bar.response(last * (1.0 - 1e-12)).force, bar.response(last).force, 1e-9 * bar.response(last).force);
}

// The beam equation integrated twice from the moments that the friction ±τ of the two slip zones gives.
RC_GTEST_PROP(BendingRoot, IsTheBeamUnderItsFriction, ()) {
  const double ei = any_decade(1.0, 1e4), tau = any_decade(1e2, 1e5), length = any_decade(0.01, 1.0), d = any_decade(1e-3, 1.0);
  const BendingRoot root(ei, tau, length);
  const double force = d * tau, clamp = root.slipped_length(force), a = 0.5 * (clamp - d);
  const auto moment = [&](double x) {
    if (x > clamp) return force * (clamp + length - x);
    return 0.5 * tau * (x <= a ? x * x : a * a + 2.0 * a * (x - a) - (x - a) * (x - a));
  };
  RC_ASSERT(near(moment(clamp), force * length, 1e-10));
  const double end = clamp + length;
  const double u = integrate([&](double x) { return moment(x) * (end - x) / ei; }, std::array{0.0, a, clamp, end});
  RC_ASSERT(near(root.displacement(force), u, 1e-11));
}

TEST(Scaled, MultipliesForcesOnly) {
  const auto law = std::shared_ptr(make_element("ren", std::array{1e-7, 2.0, 1e7}));
  const Scaled twice(law, 2.0);
  EXPECT_EQ(twice.response(3e-7).force, 2.0 * law->response(3e-7).force);
  EXPECT_EQ(twice.displacement(2.0), law->displacement(1.0));
  EXPECT_EQ(twice.values(), law->values());
}

TEST(Scaled, HasSlipLimitsInProportionToTheLoad) {
  const auto law = std::shared_ptr(make_element("bilinear", std::array{1.5e-5, 2e6}));
  const auto same = make_element("bilinear", std::array{3.75e-5, 2e6});
  const Scaled clamped(law, 2.5, 2.5);
  ASSERT_EQ(clamped.kinks().size(), 1U);
  EXPECT_DOUBLE_EQ(clamped.kinks().front(), same->kinks().front());
  EXPECT_DOUBLE_EQ(clamped.limit(), 75.0);
  for (const double u : {1e-6, 2e-5, 3.7e-5, 4e-5, 1e-3}) {
    EXPECT_DOUBLE_EQ(clamped.response(u).force, same->response(u).force) << u;
    EXPECT_DOUBLE_EQ(clamped.response(u).tangent, same->response(u).tangent) << u;
    EXPECT_NEAR(clamped.energy(u), same->energy(u), 1e-12 * same->energy(u)) << u;
    EXPECT_NEAR(clamped.cycle_energy(u), same->cycle_energy(u), 1e-11 * same->energy(u)) << u;
    EXPECT_NEAR(clamped.equivalent_stiffness(u), same->equivalent_stiffness(u), 1e-9 * same->equivalent_stiffness(u)) << u;
    EXPECT_NEAR(clamped.second_moment(u), same->second_moment(u), 1e-9 * same->second_moment(u)) << u;
  }
  EXPECT_DOUBLE_EQ(clamped.displacement(50.0), same->displacement(50.0));
}

RC_GTEST_PROP(Scaled, IsItsOwnDerivativeAndIntegral, ()) {
  const auto law = std::shared_ptr(any_element());
  const double factor = any_in(0.2, 5.0), stretch = any_in(0.2, 5.0), u = any_in(1e-7, 1e-5);
  const Scaled clamped(law, factor, stretch);
  const double step = 1e-6 * u;
  RC_ASSERT(near((clamped.energy(u + step) - clamped.energy(u - step)) / (2.0 * step), clamped.response(u).force, 1e-4));
  std::vector<double> slopes(clamped.parameters().size()), values = clamped.values();
  clamped.derivative(u, slopes);
  for (std::size_t p = 0; p < values.size(); ++p) {
    std::vector<double> above = values;
    above[p] *= 1.0 + 1e-6;
    const double difference = clamped.with(above)->response(u).force - clamped.response(u).force;
    RC_ASSERT(std::abs(difference - slopes[p] * (above[p] - values[p])) <= 1e-4 * std::abs(difference) + 1e-9 * clamped.response(u).force);
  }
}

TEST(Joint, SenselessValuesAreRefused) {
  EXPECT_THROW(Ring(make_element("spring", std::array{1.0}), 0.1, 0.1), InputError);
  EXPECT_THROW(MenqBar({1.0, 1.0, 1.0, 1.0, -1.0}), InputError);
  EXPECT_THROW(BendingRoot(1.0, 0.0, 1.0), InputError);
  EXPECT_THROW(Scaled(make_element("spring", std::array{1.0}), 0.0), InputError);
  EXPECT_THROW(Scaled(make_element("spring", std::array{1.0}), 1.0, 0.0), InputError);
}

}  // namespace
}  // namespace jointid::friction

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <numbers>
#include <stdexcept>

#include "friction/curve/equivalent.hpp"
#include "base/error.hpp"
#include "friction/law/sliders.hpp"
#include "friction/path/cancellation_free.hpp"
#include "friction/path/masing_path.hpp"
#include "friction/path/quadrature.hpp"
#include "random_element.hpp"

namespace jointid::friction {
namespace {

std::shared_ptr<const Element> part(const std::string& law, const std::vector<double>& values) {
  return make_element(law, values);
}

RC_GTEST_PROP(Iwan, LosesAtOnePercentOfTheSlipWhatItsSlidersLose, ()) {
  const auto iwan = make_element("iwan", any_values("iwan"));
  const double power = iwan->values()[2] + 1.0, slip = iwan->kinks()[0], u = 0.01 * slip;
  // Density of sliders k·power·φ^χ/((1 + β)φ_max^power); each loses 4φ(u − φ). With φ = u t^{1/power} the density is even.
  const double sum = integrate([&](double t) { return 4.0 * u * std::pow(t, 1.0 / power) * (u - u * std::pow(t, 1.0 / power)); },
                               std::array{0.0, 1.0});
  const double expected = iwan->values()[1] * std::pow(0.01, power) / (1.0 + iwan->values()[3]) * sum;
  RC_ASSERT(std::abs(iwan->cycle_energy(u) / expected - 1.0) < 1e-10);
}

TEST(Iwan, AHundredEvenSlidersMissTheLossAtOnePercent) {
  const auto iwan = make_element("iwan", std::array{1000.0, 1e7, -0.5, 0.5});
  const double slip = iwan->kinks()[0];
  std::vector<double> knots;
  for (int i = 1; i <= 100; ++i) knots.push_back(0.01 * i * slip);
  const double even = bilinear_assembly(sliders(*iwan, knots))->cycle_energy(0.015 * slip);
  EXPECT_GT(std::abs(even / iwan->cycle_energy(0.015 * slip) - 1.0), 0.2);
}

TEST(GeneralizedSlip, OfManyPointsIsTheLawThatTheyComeFrom) {
  const double a = 5e-8, b = 3.0, k = 1e6;
  const auto ren = make_element("ren", std::array{a, b, k});
  const auto error = [&](int intervals) {
    std::vector<SlipPoint> table;
    for (int i = 0; i <= intervals; ++i) table.push_back({double(i) / intervals, a * std::exp(b * i / intervals)});
    const GeneralizedSlip general(k, table);
    EXPECT_NEAR(general.limit(), ren->limit(), 10.0 * ren->limit() / (intervals * intervals));
    return std::abs(general.response(4e-7).force - ren->response(4e-7).force);
  };
  EXPECT_NEAR(error(50) / error(200), 16.0, 1.0);
}

TEST(GeneralizedSlip, OfEqualDisplacementsIsBilinear) {
  const GeneralizedSlip table(1e6, {{0.0, 2e-7}, {1.0, 2e-7}});
  for (const double u : {1e-7, 3e-7}) {
    EXPECT_DOUBLE_EQ(table.response(u).force, 1e6 * std::min(u, 2e-7));
    EXPECT_DOUBLE_EQ(table.response(u).tangent, u < 2e-7 ? 1e6 : 0.0);
  }
}

TEST(GeneralizedSlip, ThatEndsBelowOneStaysElastic) {
  const GeneralizedSlip table(1e6, {{0.0, 1e-7}, {0.75, 2e-7}});
  EXPECT_TRUE(std::isinf(table.limit()));
  EXPECT_DOUBLE_EQ(table.response(5e-7).tangent, 0.25e6);
}

TEST(GeneralizedSlip, WrongTablesAreRefused) {
  EXPECT_THROW(GeneralizedSlip(1e6, {}), InputError);
  EXPECT_THROW(GeneralizedSlip(-1.0, {{0.0, 1e-7}}), InputError);
  EXPECT_THROW(GeneralizedSlip(1e6, {{0.1, 1e-7}}), InputError);
  EXPECT_THROW(GeneralizedSlip(1e6, {{0.0, 2e-7}, {0.5, 1e-7}}), InputError);
  EXPECT_THROW(GeneralizedSlip(1e6, {{0.0, 1e-7}, {1.5, 2e-7}}), InputError);
}

TEST(Series, OfABilinearElementAndASpringIsBilinear) {
  const Series series({part("bilinear", {2e-7, 1e7}), part("spring", {1e7})});
  const auto expected = make_element("bilinear", std::array{4e-7, 0.5e7});
  for (const double u : {1e-7, 3.9e-7, 4.1e-7, 1e-6}) {
    EXPECT_NEAR(series.response(u).force, expected->response(u).force, 1e-14);
    EXPECT_NEAR(series.response(u).tangent, expected->response(u).tangent, 1e-6);
    EXPECT_NEAR(series.energy(u), expected->energy(u), 1e-20);
    EXPECT_NEAR(series.cycle_energy(u), expected->cycle_energy(u), 1e-20);
  }
  EXPECT_NEAR(series.kinks().at(0), 4e-7, 1e-20);
}

// A series is not a sum of sliders at hand: its parts move along Masing paths of their own under the common force.
TEST(Series, MovesAsItsPartsDo) {
  const Parts parts = {part("ren", {1e-7, 2.0, 1e7}), part("shoukry", {20.0, 1e6})};
  const Series series(parts);
  MasingPath path(series), first(*parts[0]), second(*parts[1]);
  for (const auto& [u, v] : {std::pair{3e-7, 6e-8}, {-2e-7, -7e-8}, {1e-7, 1e-8}, {4e-7, 8e-8}}) {
    first.advance(u);
    // The second part follows to the same force: secant steps along its path.
    double low = v - 5e-6, high = v + 5e-6;
    for (int i = 0; i < 200; ++i) {
      const double middle = 0.5 * (low + high);
      (second.response(middle).force < first.force() ? low : high) = middle;
    }
    second.advance(low);
    EXPECT_NEAR(path.advance(u + low).force, first.force(), 1e-9);
  }
}

TEST(Assembly, NumbersTheParametersOfItsParts) {
  const Parallel parallel({part("ren", {1e-7, 2.0, 1e7}), part("spring", {1e6})});
  ASSERT_EQ(parallel.parameters().size(), 4U);
  EXPECT_EQ(parallel.parameters()[3].name, "2.k");
  EXPECT_THROW(parallel.with(std::array{1.0}), InputError);
  EXPECT_THROW(Parallel{Parts{}}, InputError);
}

// Against (B.4) of docs/formulas.md §10c, with the cosine.
RC_GTEST_PROP(EquivalentStiffness, IsThePrintedIntegral, ()) {
  const auto element = any_element();
  const double u = any_displacement(*element);
  std::vector<double> angles = {0.0};
  for (const double kink : element->kinks()) {
    if (kink < u) angles.push_back(std::acos(1.0 - 2.0 * kink / u));
  }
  angles.push_back(std::numbers::pi);
  const auto integrand = [&](double t) { return element->response(0.5 * u * (1.0 - std::cos(t))).force * std::cos(t); };
  const double printed = -4.0 / (std::numbers::pi * u) * integrate(integrand, angles);
  const Equivalent found = equivalent(*element, u);
  RC_LOG() << describe(*element) << u << '\n';
  RC_ASSERT(std::abs(found.stiffness - printed) < 1e-10 * element->response(u).force / u);
  RC_ASSERT(found.loss_factor == found.damping / found.stiffness);
}

RC_GTEST_PROP(EquivalentDerivative, IsTheSlopeOfTheFigures, ()) {
  const auto element = any_single();
  const double u = any_displacement(*element);
  const std::vector<double> values = element->values();
  // Where macroslip begins, k_e has an infinite second derivative.
  for (const double kink : element->kinks()) RC_PRE(std::abs(kink / u - 1.0) > 0.02);
  const EquivalentDerivative found = equivalent_derivative(*element, u);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double step = 1e-5 * std::abs(values[i]);
    const auto at = [&](double times) {
      std::vector<double> other = values;
      other[i] += times * step;
      return equivalent(*element->with(other), u);
    };
    const Equivalent up = at(1), down = at(-1);
    const double scale = element->response(u).force / (u * std::abs(values[i]));
    RC_ASSERT(std::abs((up.stiffness - down.stiffness) / (2.0 * step) - found.stiffness[i]) <= 1e-5 * scale);
    RC_ASSERT(std::abs((up.damping - down.damping) / (2.0 * step) - found.damping[i]) <= 1e-5 * scale);
  }
}

TEST(Equivalent, WrongAmplitudesAreRefused) {
  const auto element = make_element("spring", std::array{1.0});
  EXPECT_THROW(equivalent(*element, 0.0), InputError);
  EXPECT_EQ(equivalent(*element, std::array{1.0, 2.0}).size(), 2U);
}

TEST(CancellationFree, BothSidesOfTheSwitchAgree) {
  for (const auto& [function, at] : {std::pair<double (*)(double), double>{linear_minus_exponential, 1.0}, {exponential_excess, 1.0},
                                     {damped_hyperbolic_excess, 1.0}, {exponential_second_moment, 2.0},
                                     {circular_segment, 0.5}, {scaled_bessel_i1, 40.0}}) {
    const double below = function(std::nextafter(at, 0.0)), above = function(std::nextafter(at, 100.0));
    EXPECT_NEAR(below / above, 1.0, 3e-15);
  }
  EXPECT_EQ(linear_minus_exponential(0.0), 0.0);
  EXPECT_NEAR(exponential_second_moment(1e-6) / (1e-24 / 4.0 - 1e-30 / 10.0), 1.0, 1e-12);
}

}  // namespace
}  // namespace jointid::friction

#include "friction/law/laws.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <numbers>

#include "base/error.hpp"
#include "friction/path/quadrature.hpp"
#include "random_element.hpp"

namespace jointid::friction {
namespace {

using testing::HasSubstr;

bool near(double value, double expected, double relative) {
  if (std::abs(value - expected) <= relative * std::abs(expected)) return true;
  RC_LOG() << value << " instead of " << expected << ", relative " << value / expected - 1.0 << '\n';
  return false;
}

/// The formulas of docs/formulas.md §10a, with more digits so that their differences do not matter.
long double printed_force(const std::string& law, const std::vector<double>& p, long double u) {
  const long double first = p[0], second = p.size() > 1 ? p[1] : 0.0L;
  if (law == "ren") {
    const long double a = first, b = second, k = p[2];
    if (u <= a) return k * u;
    if (u > a * std::exp(b)) return k * a * (std::exp(b) - 1.0L) / b;
    return k / b * (u - a + u * (b - std::log(u / a)));
  }
  if (law == "shoukry") return first * (1.0L - std::exp(-second * u));
  if (law == "burdekin") {
    return u < -first / (2.0L * second) ? first * u + second * u * u : -first * first / (4.0L * second);
  }
  if (law == "iwan") {  // with the density Rφ^χ and S sliders at φ_max
    const long double f = first, k = second, power = p[2] + 1.0L, beta = p[3];
    const long double end = f * (1.0L + beta) / (k * (beta + power / (power + 1.0L)));
    const long double scale = beta + power / (power + 1.0L);
    const long double r = f * power / (std::pow(end, power + 1.0L) * scale), s = f / end * beta / scale;
    const long double v = std::min(u, end);
    return r * (std::pow(v, power + 1.0L) / (power + 1.0L) + v * (std::pow(end, power) - std::pow(v, power)) / power) + s * v;
  }
  if (law == "bilinear") return second * std::min(u, first);
  return first * u;
}

RC_GTEST_PROP(Law, ForceIsThePrintedFormula, ()) {
  const std::string name = any_law();
  const std::vector<double> values = any_values(name);
  const auto element = make_element(name, values);
  const double u = any_displacement(*element);
  RC_ASSERT(near(element->response(u).force, static_cast<double>(printed_force(name, values, u)), 1e-12));
}

RC_GTEST_PROP(Law, TangentIsTheDerivativeOfTheForce, ()) {
  const auto element = any_element();
  const double u = any_displacement(*element), step = 1e-4 * u;
  for (const double kink : element->kinks()) RC_PRE(std::abs(u - kink) > 2.0 * step);
  const auto force = [&](double v) { return element->response(v).force; };
  const double slope = (8.0 * (force(u + step) - force(u - step)) - (force(u + 2 * step) - force(u - 2 * step))) / (12.0 * step);
  RC_ASSERT(std::abs(slope - element->response(u).tangent) <= 1e-9 * force(u) / u);
}

RC_GTEST_PROP(Law, EnergyIsTheIntegralOfTheForce, ()) {
  const auto element = any_element();
  const double u = any_displacement(*element);
  std::vector<double> ends = {0.0};
  for (const double kink : element->kinks()) {
    if (kink < u) ends.push_back(kink);
  }
  ends.push_back(u);
  const double area = integrate([&](double v) { return element->response(v).force; }, ends);
  RC_ASSERT(near(element->energy(u), area, 1e-12));
}

RC_GTEST_PROP(Law, TheClosedFormsAreTheIntegrals, ()) {
  const auto element = any_element();
  const double u = any_displacement(*element);
  RC_ASSERT(near(element->second_moment(u), element->Element::second_moment(u), 1e-12));
  RC_ASSERT(near(element->equivalent_stiffness(u), element->Element::equivalent_stiffness(u), 1e-12));
  const double scale = element->energy(u);
  RC_ASSERT(std::abs(element->cycle_energy(u) - element->Element::cycle_energy(u)) <= 1e-13 * scale);
}

RC_GTEST_PROP(Law, TheMomentsOfTheDerivativesAreTheIntegrals, ()) {
  const auto element = any_element();
  const double u = any_displacement(*element);
  const std::vector<double> values = element->values();
  std::vector<double> closed(values.size()), quadrature(values.size());
  element->second_moment_derivative(u, closed);
  element->Element::second_moment_derivative(u, quadrature);
  for (std::size_t i = 0; i < values.size(); ++i) {
    RC_ASSERT(std::abs(closed[i] - quadrature[i]) <= 1e-8 * element->second_moment(u) / std::abs(values[i]));
  }
}

RC_GTEST_PROP(Law, DisplacementIsTheInverse, ()) {
  const auto element = any_element();
  const double u = any_displacement(*element), force = element->response(u).force;
  const double back = element->displacement(force);
  if (std::isinf(back)) {
    RC_ASSERT(force == element->limit());  // which is reached only by rounding
  } else {
    RC_ASSERT(near(element->response(back).force, force, 1e-15));
  }
  RC_ASSERT(std::isinf(element->displacement(1.001 * element->limit())));
}

void expect_derivatives(const Element* element, double relative) {
  const double u = any_displacement(*element);
  const std::vector<double> values = element->values();
  std::vector<double> derivative(values.size());
  element->derivative(u, derivative);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double step = 1e-4 * std::abs(values[i]);
    const auto shifted = [&](double times) {
      std::vector<double> other = values;
      other[i] += times * step;
      const auto changed = element->with(other);
      RC_PRE(changed->kinks().size() == element->kinks().size());
      for (std::size_t j = 0; j < changed->kinks().size(); ++j) {
        RC_PRE((changed->kinks()[j] < u) == (element->kinks()[j] < u));
      }
      return changed->response(u).force;
    };
    const double slope = (8.0 * (shifted(1) - shifted(-1)) - (shifted(2) - shifted(-2))) / (12.0 * step);
    RC_ASSERT(std::abs(slope - derivative[i]) <= relative * element->response(u).force / std::abs(values[i]));
  }
}

RC_GTEST_PROP(Law, DerivativesByParameters, ()) { expect_derivatives(any_single().get(), 1e-8); }

RC_GTEST_PROP(Assembly, DerivativesByParameters, ()) { expect_derivatives(any_element().get(), 1e-6); }

TEST(Law, RenWithoutSpreadIsBilinear) {
  const auto bilinear = make_element("bilinear", std::vector{2e-7, 5e7});
  for (const double spread : {0.0, 1e-13}) {
    const auto ren = make_element("ren", std::vector{2e-7, spread, 5e7});
    for (const double u : {1e-7, 2e-7, 3e-7}) {
      EXPECT_NEAR(ren->response(u).force, bilinear->response(u).force, 1e-12);
      EXPECT_NEAR(ren->energy(u), bilinear->energy(u), 1e-18);
      EXPECT_NEAR(ren->cycle_energy(u), bilinear->cycle_energy(u), 1e-17);
    }
    std::vector<double> derivative(3);
    ren->derivative(3e-7, derivative);
    EXPECT_NEAR(derivative[1], 0.5 * 5e7 * 2e-7, 1e-11);
  }
}

TEST(Law, WorkedValues) {
  const auto ren = make_element("ren", std::vector{3.43e-8, 2.79, 5.82e7});
  EXPECT_NEAR(ren->limit(), 10.93365182, 5e-9);
  EXPECT_NEAR(ren->equivalent_stiffness(4e-7), 2.486537e7, 5.0);
  EXPECT_NEAR(ren->cycle_energy(4e-7) / (std::numbers::pi * 4e-7 * 4e-7), 1.1100150e7, 0.5);
}

TEST(Law, ParametersCarryNamesUnitsAndBounds) {
  const auto parameters = make_element("ren", std::vector{1e-8, 0.0, 1e7})->parameters();
  ASSERT_EQ(parameters.size(), 3U);
  EXPECT_EQ(parameters[0].name, "a");
  EXPECT_EQ(parameters[0].unit, "m");
  EXPECT_EQ(parameters[2].value, 1e7);
  EXPECT_TRUE(parameters[1].lower_included);
}

void expect_refused(const std::string& name, const std::vector<double>& values, const std::string& text) {
  try {
    make_element(name, values);
    FAIL() << name;
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(text));
  }
}

/// Values of which one or none makes sense.
std::vector<double> disturbed(std::vector<double> values) {
  const std::vector<double> strange = {0.0, -1.0, 1e300, std::nan(""), infinity, -infinity};
  const std::size_t i = any_of(values.size() + 1), with = any_of(strange.size());
  if (i < values.size()) values[i] = strange[with];
  if (any_of(8) == 0) values.pop_back();
  return values;
}

RC_GTEST_PROP(Law, AdmitsJustTheValuesThatItCanHave, ()) {
  const auto element = any_element();
  const std::vector<double> values = disturbed(element->values());
  bool made = true;
  try {
    (void)element->with(values);
  } catch (const InputError&) {
    made = false;
  }
  RC_ASSERT(element->admits(values) == made);
}

TEST(Law, SenselessValuesAreRefused) {
  expect_refused("ren", {1e-8, -1.0, 1e7}, "ren: b = -1.000000 1 must be finite and >= 0");
  expect_refused("ren", {1e-8, 1.0}, "2 values for 3 parameters");
  expect_refused("burdekin", {1e7, 1e13}, "burdekin: b");
  expect_refused("bilinear", {std::nan(""), 1e7}, "bilinear: a = nan");
  expect_refused("renn", {1.0}, "valid: ren, shoukry");
}

}  // namespace
}  // namespace jointid::friction

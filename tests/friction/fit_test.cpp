#include "friction/fit/fit.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "base/control.hpp"
#include "base/error.hpp"
#include "friction/fit/fit_problem.hpp"
#include "friction/law/laws.hpp"
#include "minimise/least_squares.hpp"
#include "tests/require.hpp"

namespace jointid::friction {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// A loading curve of an element on `points` even steps to `most`, with normal errors of `noise` times its largest force.
Curve loading(const Element& element, double most, std::size_t points, double noise, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Record record;
  const double scale = noise * element.response(most).force;
  for (std::size_t i = 1; i <= points; ++i) {
    record.displacement.push_back(most * static_cast<double>(i) / static_cast<double>(points));
    record.force.push_back(element.response(record.displacement.back()).force + scale * normal(random));
  }
  return loading_curve("made", std::move(record));
}

Fit fit_one(const Curve& curve, const std::string& law, const FitOptions& options = {}) {
  return fit(std::span(&curve, 1), family(law), options);
}

const FittedValue& value(const Fit& fit, const std::string& name, std::size_t curve = 0) {
  const auto& all = fit.curves[curve].parameters;
  return *std::ranges::find(all, name, &FittedValue::name);
}

const std::vector<double> ren = {3.43e-8, 2.79, 5.707e8};

struct Exact {
  const char* law;
  std::vector<double> values;
};
const Exact exact_cases[] = {
    {"ren", ren}, {"shoukry", {114.0, 5.5e6}}, {"burdekin", {5.5e8, -7.9e14}}, {"bilinear", {2e-7, 5.5e8}}, {"spring", {5e8}}};

TEST(Fit, ExactCurvesGiveTheirParametersBack) {
  for (const Exact& each : exact_cases) {
    const auto element = make_element(each.law, each.values);
    const Fit found = fit_one(loading(*element, 6e-7, 60, 0.0, 1), each.law);
    EXPECT_EQ(found.status, Status::ok) << found.message;
    EXPECT_LT(found.objective, 1e-16) << each.law;
    for (std::size_t i = 0; i < each.values.size(); ++i) {
      EXPECT_NEAR(found.curves[0].parameters[i].value / each.values[i], 1.0, 1e-7) << each.law << i;
    }
  }
}

RC_GTEST_PROP(Fit, OfRandomRenElementsFindsThem, ()) {
  const auto within = [](double low, double high) { return low * std::pow(high / low, *rc::gen::inRange(0, 1001) / 1000.0); };
  const std::vector<double> values = {within(1e-9, 1e-3), within(1.0, 6.0), within(1e3, 1e10)};
  const auto element = make_element("ren", values);
  const double end = values[0] * std::exp(values[1]);
  const Fit found = fit_one(loading(*element, end * within(0.7, 4.0), 150, 0.0, 1), "ren");
  RC_ASSERT(found.objective < 1e-12);
  for (std::size_t i = 0; i < 3; ++i) RC_ASSERT(std::abs(found.curves[0].parameters[i].value / values[i] - 1.0) < 1e-4);
}

TEST(Fit, ThePatternSearchOfTheThesisFindsTheSameMinimum) {
  for (const Exact& each : exact_cases) {
    const Curve curve = loading(*make_element(each.law, each.values), 6e-7, 60, 0.01, 7);
    const Fit fast = fit_one(curve, each.law), thesis = fit_one(curve, each.law, {.minimiser = Minimiser::pattern});
    EXPECT_EQ(thesis.minimiser, "pattern");
    EXPECT_EQ(thesis.status, Status::ok);
    EXPECT_NEAR(fast.weighted_sum / thesis.weighted_sum, 1.0, 1e-9) << each.law;
    for (std::size_t i = 0; i < each.values.size(); ++i) {
      EXPECT_NEAR(fast.curves[0].parameters[i].value / thesis.curves[0].parameters[i].value, 1.0, 1e-4) << each.law << i;
    }
  }
}

TEST(Fit, NoStartOfTwoThousandLeadsBelowTheOneFromFeatures) {
  for (const Exact& each : exact_cases) {
    const Curve curve = loading(*make_element(each.law, each.values), 3e-7, 40, 0.02, 3);
    const Fit plain = fit_one(curve, each.law);
    const FitProblem problem(std::span(&curve, 1), family(each.law), {});
    const auto squares = [&](std::span<const double> q) { return problem.objective(q); };
    std::mt19937 random(5);
    std::uniform_real_distribution<double> within(-4.0, 4.0);
    std::vector<double> best = problem.starts().front();
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 2000; ++i) {
      std::vector<double> q = problem.starts().front();
      for (double& logarithm : q) logarithm += within(random);
      if (const double sum = squares(q); sum < least) {
        least = sum;
        best = q;
      }
    }
    const double found = squares(minimise::pattern_search(squares, best).q);
    ASSERT_TRUE(std::isfinite(found)) << each.law;
    EXPECT_LT(plain.weighted_sum, found * (1.0 + 1e-8)) << each.law;
  }
}

TEST(Fit, UnitsOfForceAndDisplacementDoNotMatter) {
  const auto element = make_element("ren", ren);
  const Curve curve = loading(*element, 6e-7, 60, 0.01, 5);
  Curve other = curve;
  for (double& u : other.u) u *= 1e9;
  for (double& force : other.value) force *= 1e-3;
  const Fit one = fit_one(curve, "ren"), two = fit_one(other, "ren");
  EXPECT_NEAR(value(two, "a").value / value(one, "a").value, 1e9, 1e3);
  EXPECT_NEAR(value(two, "b").value / value(one, "b").value, 1.0, 1e-6);
  EXPECT_NEAR(*value(two, "k").std_error / *value(one, "k").std_error * 1e12, 1.0, 1e-4);
  EXPECT_NEAR(two.aic, one.aic, 1e-6 * std::abs(one.aic));
}

TEST(Fit, StandardErrorsAreTheScatterOfTheEstimates) {
  const auto element = make_element("ren", ren);
  constexpr unsigned trials = 300;
  double sum = 0.0, squares = 0.0, predicted = 0.0, limit_squares = 0.0, limit_predicted = 0.0;
  for (unsigned seed = 1; seed <= trials; ++seed) {
    const Fit found = fit_one(loading(*element, 6e-7, 50, 0.01, seed), "ren");
    const double b = value(found, "b").value;
    sum += b;
    squares += b * b;
    predicted += *value(found, "b").std_error / trials;
    limit_squares += std::pow(found.curves[0].limit.value - element->limit(), 2) / trials;
    limit_predicted += *found.curves[0].limit.std_error / trials;
  }
  EXPECT_NEAR(std::sqrt(squares / trials - sum * sum / trials / trials) / predicted, 1.0, 0.15);
  EXPECT_NEAR(std::sqrt(limit_squares) / limit_predicted, 1.0, 0.15);
}

TEST(Fit, APresetLimitIsKeptAndTakesOneUnknownAway) {
  const auto element = make_element("ren", ren);
  const Curve curve = loading(*element, 3e-7, 60, 0.01, 5);
  const Fit free = fit_one(curve, "ren"), tied = fit_one(curve, "ren", {.limit = element->limit()});
  EXPECT_EQ(tied.unknowns, 2u);
  EXPECT_NEAR(tied.curves[0].element->limit(), element->limit(), 1e-9 * element->limit());
  EXPECT_EQ(tied.curves[0].limit.knowledge, Knowledge::preset);
  EXPECT_GE(tied.weighted_sum, free.weighted_sum);
  for (const FittedValue& each : tied.curves[0].parameters) {
    ASSERT_TRUE(each.std_error);
    EXPECT_LT(*each.std_error, *value(free, each.name).std_error) << each.name;
  }
  const Fit shoukry = fit_one(curve, "shoukry", {.limit = element->limit()});
  EXPECT_EQ(value(shoukry, "a").knowledge, Knowledge::preset);
  EXPECT_EQ(value(shoukry, "b").knowledge, Knowledge::determined);
  EXPECT_THROW(fit_one(curve, "spring", {.limit = 1.0}), InputError);
  EXPECT_THROW(fit_one(curve, "ren", {.limit = -1.0}), InputError);
}

TEST(Fit, LoopsEnergiesAndEquivalentsLeadToTheSameElement) {
  const auto element = make_element("ren", ren);
  Curve loop, energy, equivalent;
  for (int i = 0; i <= 200; ++i) loop.u.push_back(6e-7 * (std::abs(i - 100.0) / -50.0 + 1.0));
  loop.kind = CurveKind::loop;
  loop.turn = 100;
  loop.value.assign(loop.u.size(), 0.0);
  loop.value = predicted(*element, loop);
  energy.kind = CurveKind::energy;
  equivalent.kind = CurveKind::equivalent;
  for (int i = 1; i <= 12; ++i) {
    const double x = 6e-7 * i / 12.0;
    energy.u.push_back(x);
    energy.value.push_back(element->cycle_energy(x));
    equivalent.u.push_back(x);
    equivalent.value.push_back(element->equivalent_stiffness(x));
    equivalent.damping.push_back(element->cycle_energy(x) / (M_PI * x * x));
  }
  for (const Curve& curve : {loop, energy, equivalent}) {
    const Fit found = fit_one(curve, "ren");
    EXPECT_EQ(found.status, Status::ok);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(found.curves[0].parameters[i].value / ren[i], 1.0, 1e-5) << "kind " << static_cast<int>(curve.kind) << " parameter " << i;
    }
  }
}

/// In the middle of a minimisation, by every minimiser.
TEST(Fit, EndsWhereItIsInterrupted) {
  const std::vector<double> values = {3e-8, 3.1, 1e7};
  const std::vector<Curve> curves = {loading(*make_element("ren", values), 1e-6, 60, 0.01, 3u)};
  for (const Minimiser minimiser : {Minimiser::best, Minimiser::pattern}) {
    int asked = 0;
    const auto after = [&asked](int most) { return [&asked, most] { return ++asked > most; }; };
    EXPECT_NO_THROW(fit(curves, family("ren"), {.minimiser = minimiser, .interrupted = after(1'000'000)}));
    const int all = asked;
    asked = 0;
    EXPECT_THROW(fit(curves, family("ren"), {.minimiser = minimiser, .interrupted = after(5)}), Interrupted);
    EXPECT_GT(all, 10);
  }
}

TEST(Fit, CurvesWithOneShapeAndOneFrictionCoefficient) {
  const double mu = 0.23, loads[] = {490.0, 981.0, 1961.0};
  std::vector<Curve> curves;
  for (int i = 0; i < 3; ++i) {
    const double a = 3e-8 * (i + 1), b = 3.1, limit = mu * loads[i];
    const std::vector<double> values = {a, b, limit * b / (a * std::expm1(b))};
    curves.push_back(loading(*make_element("ren", values), 0.8 * a * std::exp(b), 60, 0.01, 11u + static_cast<unsigned>(i)));
    curves.back().name = std::to_string(static_cast<int>(loads[i])) + " N";
    curves.back().normal_load = loads[i];
  }
  const FitOptions options{.friction_coefficient = true, .shared = {"b"}};
  const Fit found = fit(curves, family("ren"), options);
  EXPECT_EQ(found.status, Status::ok);
  EXPECT_THAT(found.names, testing::ElementsAre("mu", "b", "k of 490 N", "k of 981 N", "k of 1961 N"));
  const FittedValue& coefficient = *found.curves[0].friction_coefficient;
  EXPECT_NEAR(coefficient.value, mu, 3.5 * *coefficient.std_error);
  EXPECT_LT(*coefficient.std_error, 0.03 * mu);
  for (const CurveFit& each : found.curves) {
    EXPECT_NEAR(each.limit.value, coefficient.value * *each.curve.normal_load, 1e-9 * each.limit.value);
    EXPECT_EQ(each.parameters[1].value, found.curves[0].parameters[1].value);
  }
  const Fit alone = fit(std::span(curves).first(1), family("ren"));
  EXPECT_LT(*coefficient.std_error, *alone.curves[0].friction_coefficient->std_error);
  EXPECT_THROW(fit(curves, family("ren"), {.shared = {"c"}}), InputError);
  curves[1].normal_load.reset();
  EXPECT_THROW(fit(curves, family("ren"), options), InputError);
}

TEST(Fit, WhatTheCurveCannotTellIsSaid) {
  const auto element = make_element("ren", ren);
  const Fit far = fit_one(loading(*element, 8e-7, 80, 0.01, 3), "ren");
  EXPECT_EQ(far.curves[0].limit.knowledge, Knowledge::determined);
  EXPECT_THAT(far.findings, testing::IsEmpty());
  const Fit micro = fit_one(loading(*element, 3e-7, 80, 0.01, 3), "ren");
  EXPECT_EQ(micro.curves[0].limit.knowledge, Knowledge::extrapolated);
  EXPECT_THAT(micro.findings, Contains(HasSubstr("friction limit is extrapolated by the law")));
  const Fit elastic = fit_one(loading(*element, 3e-8, 80, 0.01, 3), "bilinear");
  EXPECT_EQ(elastic.curves[0].limit.knowledge, Knowledge::undetermined);
  EXPECT_THAT(elastic.findings, Contains(HasSubstr("friction limit is not determined")));
  EXPECT_THAT(elastic.findings, Contains(HasSubstr("slip is not seen")));
  EXPECT_EQ(value(elastic, "k").knowledge, Knowledge::determined);
}

TEST(Fit, ResidualsThatAreNotIndependentAreSaid) {
  const auto element = make_element("ren", ren);
  const Curve curve = loading(*element, 8e-7, 200, 0.001, 3);
  EXPECT_NEAR(fit_one(curve, "ren").neighbour_correlation, 0.0, 0.2);
  const Fit wrong = fit_one(curve, "bilinear");
  EXPECT_GT(wrong.neighbour_correlation, 0.9);
  EXPECT_THAT(wrong.findings, Contains(HasSubstr("residuals of neighbouring samples are correlated")));
}

TEST(Fit, TooFewPointsAreAStatus) {
  const Fit found = fit_one(loading(*make_element("ren", ren), 6e-7, 3, 0.0, 1), "ren");
  EXPECT_EQ(found.status, Status::too_few_points);
  EXPECT_THAT(found.message, HasSubstr("3 measured numbers cannot determine 3 unknowns"));
}

TEST(Fit, ComparisonPutsTheLawThatMadeTheCurveFirst) {
  std::vector<Family> families;
  for (const char* law : {"spring", "bilinear", "burdekin", "shoukry", "ren"}) families.push_back(family(law));
  for (const Exact& each : exact_cases) {
    if (std::string(each.law) == "spring") continue;
    const Curve curve = loading(*make_element(each.law, each.values), 6e-7, 100, 0.005, 9);
    const std::vector<Fit> fits = compare(std::span(&curve, 1), families);
    EXPECT_EQ(fits.front().law, each.law);
    for (std::size_t i = 1; i < fits.size(); ++i) EXPECT_LE(fits[i - 1].aic, fits[i].aic);
  }
}

TEST(Fit, WeightingByTravelIgnoresDwells) {
  const auto element = make_element("bilinear", std::vector{2e-7, 5.5e8});
  Curve curve = loading(*element, 6e-7, 60, 0.01, 2);
  const double before = fit_one(curve, "bilinear", {.weighting = Weighting::travel}).curves[0].limit.value;
  for (int i = 0; i < 1000; ++i) {  // a dwell in which the force creeps away
    curve.u.push_back(curve.u.back());
    curve.value.push_back(0.8 * element->limit());
  }
  EXPECT_NEAR(fit_one(curve, "bilinear", {.weighting = Weighting::travel}).curves[0].limit.value, before, 0.01 * before);
  EXPECT_LT(fit_one(curve, "bilinear").curves[0].limit.value, 0.9 * before);
}

TEST(Fit, NamesAreTheWordsOfTheCommandLine) {
  for (const Weighting each : {Weighting::none, Weighting::largest, Weighting::relative, Weighting::travel}) {
    EXPECT_EQ(parse_weighting(name(each)), each);
  }
  EXPECT_THROW(parse_weighting("big"), InputError);
  EXPECT_THROW(family("renn"), InputError);
}

}  // namespace
}  // namespace jointid::friction

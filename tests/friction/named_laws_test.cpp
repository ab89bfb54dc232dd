#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "friction/fit/fit.hpp"
#include "friction/law/laws.hpp"

/// Laws that have to be named, and arrangements of laws.
namespace jointid::friction {
namespace {

using testing::HasSubstr;

struct Named {
  std::string law;
  std::vector<double> values;
  double most = 0.0;  ///< m, beyond all kinks
};

const std::vector<Named> fitted = {{"power", {5e-8, 9e-7, 1.7, 1e6}, 1.5e-6},
                                   {"square", {5e-8, 9e-7, 1e6}, 1.5e-6},
                                   {"menq-shape", {8000.0, 1e-5, 8.9}, 5e-4},
                                   {"bending-root-shape", {6e6, 5e4}, 2e-3},
                                   {"parallel:ren:spring", {5e-8, 3.0, 1e6, 2e5}, 2e-6},
                                   {"parallel:bilinear:bilinear", {1e-7, 1e6, 1e-6, 5e5}, 2e-6}};

const std::vector<Named> others = {{"exponential-offset", {4e-8, 3.0, -2e-8, 1e6}, 1.5e-6},
                                   {"menq", {2e6, 0.2, 4e9, 4e4, 5e6}, 5e-4},
                                   {"bending-root", {2000.0, 5e5, 0.1}, 2e-3},
                                   {"series:ren:bilinear", {2e-7, 1.5, 1e6, 4e-7, 3e6}, 2e-6}};

std::vector<Named> all_named() {
  std::vector<Named> all = fitted;
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

/// T′ and ∂T/∂p against differences, energy against a sum of trapezoids, and the listed bounds.
TEST(NamedLaws, AreConsistent) {
  for (const Named& each : all_named()) {
    const auto element = make_element(each.law, each.values);
    EXPECT_TRUE(element->admits(each.values)) << each.law;
    std::vector<double> by(each.values.size());
    for (const double part : {0.013, 0.21, 0.47}) {
      const double u = part * each.most, du = 1e-6 * u, scale = element->response(u).force;
      const double slope = (element->response(u + du).force - element->response(u - du).force) / (2.0 * du);
      EXPECT_NEAR(element->response(u).tangent, slope, 1e-5 * element->response(0.0).tangent) << each.law << part;
      element->derivative(u, by);
      for (std::size_t i = 0; i < by.size(); ++i) {
        std::vector<double> up = each.values, down = each.values;
        const double step = 1e-6 * each.values[i];
        up[i] += step;
        down[i] -= step;
        const double found =
            (make_element(each.law, up)->response(u).force - make_element(each.law, down)->response(u).force) / (2.0 * step);
        EXPECT_NEAR(by[i] * each.values[i], found * each.values[i], 1e-5 * scale) << each.law << " " << i << " at " << part;
      }
    }
    double sum = 0.0;
    constexpr int steps = 4000;
    for (int i = 0; i < steps; ++i) sum += element->response(each.most * (i + 0.5) / steps).force * each.most / steps;
    EXPECT_NEAR(element->energy(each.most), sum, 1e-6 * sum) << each.law;
    const double loss = 8.0 * sum - 4.0 * each.most * element->response(each.most).force;
    EXPECT_NEAR(element->cycle_energy(each.most), loss, 1e-5 * sum) << each.law;
    EXPECT_EQ(element->with(each.values)->response(each.most).force, element->response(each.most).force);
  }
}

TEST(NamedLaws, ExactCurvesGiveTheirParametersBack) {
  for (const Named& each : fitted) {
    const auto element = make_element(each.law, each.values);
    Record record;
    for (int i = 1; i <= 80; ++i) {
      record.displacement.push_back(each.most * i / 80.0);
      record.force.push_back(element->response(record.displacement.back()).force);
    }
    const Curve curve = loading_curve("made", std::move(record));
    const Fit found = fit(std::span(&curve, 1), family(each.law));
    EXPECT_EQ(found.status, Status::ok) << each.law << found.message;
    EXPECT_LT(found.objective, 1e-12) << each.law;
    std::vector<double> values;
    for (const FittedValue& value : found.curves[0].parameters) values.push_back(value.value);
    if (each.law == "parallel:bilinear:bilinear" && values[0] > values[2])
      std::swap_ranges(values.begin(), values.begin() + 2, values.begin() + 2);
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i] / each.values[i], 1.0, 1e-5) << each.law << i;
  }
}

TEST(NamedLaws, OfWhichAMeasurementTellsTooLittleAreRefused) {
  const auto message = [](const std::string& name) {
    try {
      (void)law_to_fit(name);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_THAT(message("menq"), HasSubstr("fit menq-shape"));
  EXPECT_THAT(message("bending-root"), HasSubstr("fit bending-root-shape"));
  EXPECT_THAT(message("exponential-offset"), HasSubstr("fit ren"));
  EXPECT_THAT(message("parallel:menq:spring"), HasSubstr("fit menq-shape"));
  EXPECT_THAT(message("series:ren"), HasSubstr("name two to four"));
  EXPECT_THAT(message("parallel:ren:rem"), HasSubstr("no friction law 'rem'"));
  EXPECT_EQ(message("series:ren:spring"), "no error");
  EXPECT_EQ(&law("series:ren:spring"), &law("series:ren:spring"));
  EXPECT_THAT(law("parallel:ren:spring").has_limit, false);
  EXPECT_THROW(make_element("parallel:ren:spring", std::vector<double>{1.0}), InputError);
  for (const Law& each : named_laws()) {
    for (const Law& other : laws()) EXPECT_NE(each.name, other.name);
  }
}

}  // namespace
}  // namespace jointid::friction

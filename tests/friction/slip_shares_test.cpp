#include "friction/curve/slip_shares.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "friction/law/laws.hpp"
#include "tests/golden_json.hpp"
#include "tests/require.hpp"

namespace jointid::friction {
namespace {

/// A loading curve of a law on even displacements.
Curve curve_of(const Element& law, double largest, std::size_t samples) {
  Curve curve;
  curve.name = "curve";
  for (std::size_t i = 1; i <= samples; ++i) {
    curve.u.push_back(largest * static_cast<double>(i) / static_cast<double>(samples));
    curve.value.push_back(law.response(curve.u.back()).force);
  }
  return curve;
}

TEST(SlipDisplacement, OfShoukryMeetsTheGoldenNumbers) {
  const nlohmann::json golden = golden_case("seeds.json", "name", "uh_from_slopes_shoukry");
  if (golden.is_null()) JOINTID_SKIP("no golden seeds");
  const nlohmann::json& one = golden["expected"];
  const std::vector<double> values = {one["a"], one["b"]};
  const auto law = make_element("shoukry", values);
  EXPECT_NEAR(law->response(0.0).tangent / one["k"].get<double>(), 1.0, 1e-12);
  for (std::size_t i = 0; i < one["h"].size(); ++i) {
    const double u = one["u"][i];
    EXPECT_NEAR(slip_displacement(*law, one["h"][i]) / u, 1.0, 1e-10);
  }
  // From the slopes of a sampled curve with the given k; its largest slope is one of where it has slipped by a little already.
  const SlipShares found = slip_shares(curve_of(*law, 1e-6, 2000), {.stiffness = one["k"].get<double>()});
  const SlipShares plain = slip_shares(curve_of(*law, 1e-6, 2000));
  EXPECT_NEAR(plain.stiffness / one["k"].get<double>(), 1.0, 0.01);
  EXPECT_EQ(plain.forms.front().law, "shoukry");
  for (std::size_t i = 0; i < one["h"].size(); ++i) {
    const double h = one["h"][i], u = one["u"][i];
    std::size_t k = 0;
    while (found.h[k] < h) ++k;
    EXPECT_NEAR(found.u[k], u, 1e-9) << h;  // two samples
  }
  EXPECT_EQ(found.forms.front().law, "shoukry");
  EXPECT_NEAR(found.forms.front().parameters[0] / one["b"].get<double>(), 1.0, 0.01);
}

/// Each u(h) is found from the curve that it makes, with its parameters.
TEST(SlipShares, FindTheFormThatMadeTheCurve) {
  const std::vector<std::pair<std::string, std::vector<double>>> laws = {
      {"ren", {6e-8, 3.0, 1e6}}, {"power", {5e-8, 9e-7, 1.7, 1e6}}, {"square", {5e-8, 9e-7, 1e6}}};
  for (const auto& [name, values] : laws) {
    const auto law = make_element(name, values);
    const SlipShares found = slip_shares(curve_of(*law, law->kinks().back() * 0.99, 3000));
    EXPECT_NEAR(found.stiffness / values.back(), 1.0, 1e-6) << name;
    const auto own = std::ranges::find(found.forms, name, &SlipForm::law);
    ASSERT_NE(own, found.forms.end());
    EXPECT_LT(own->rms, 1e-3) << name;
    for (std::size_t i = 0; i + 1 < values.size(); ++i) EXPECT_NEAR(own->parameters[i] / values[i], 1.0, 0.02) << name << i;
    EXPECT_LE(own->rms, found.forms.front().rms + 1e-5) << name;
  }
}

/// T′(u(h)) = T′(0)(1 − h) of every law, and the kink of one that slips at once.
TEST(SlipDisplacement, IsWhereTheSlopeHasFallen) {
  const std::vector<double> values = {6.36e-8, 3.0, 1e6};
  const auto law = make_element("ren", values);
  for (const double h : {0.05, 0.4, 0.9}) {
    const double u = slip_displacement(*law, h);
    EXPECT_NEAR(u, 6.36e-8 * std::exp(3.0 * h), 1e-16);
    EXPECT_NEAR(law->response(u).tangent / 1e6, 1.0 - h, 1e-9);
  }
  const std::vector<double> sharp = {4e-7, 1e6}, soft = {1e6};
  EXPECT_NEAR(slip_displacement(*make_element("bilinear", sharp), 0.5), 4e-7, 1e-18);
  EXPECT_EQ(slip_displacement(*make_element("spring", soft), 0.5), infinity);
  EXPECT_THROW(slip_displacement(*law, 1.0), InputError);
}

TEST(SlipShares, OfWhatIsNoLoadingCurveAreAnError) {
  const std::vector<double> values = {6e-8, 3.0, 1e6}, straight = {1e6};
  const auto law = make_element("ren", values);
  Curve curve = curve_of(*law, 1e-6, 5);
  EXPECT_THROW(slip_shares(curve), InputError);  // too few
  curve = curve_of(*law, 1e-6, 200);
  curve.kind = CurveKind::loop;
  EXPECT_THROW(slip_shares(curve), InputError);
  EXPECT_THROW(slip_shares(curve_of(*make_element("spring", straight), 1e-6, 200)), InputError);  // no bend
}

}  // namespace
}  // namespace jointid::friction

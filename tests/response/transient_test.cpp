#include "response/time/transient.hpp"

#include <gtest/gtest.h>

#include "golden_motions.hpp"
#include "tests/require.hpp"

namespace jointid::response {
namespace {

using nlohmann::json;

ForceHistory pulse(const json& one) {
  return ForceHistory::half_sine(2.0 * one.at("p").get<double>() * Eigen::Vector3d::UnitX(), one.at("td"));
}

Transient march(const json& one, TransientMethod method, double delta) {
  const double length = one.at("td");
  return march_transient(jointed(one), pulse(one),
                         {.duration = 16.0 * length,
                          .step = 2.0 * length,
                          .method = method,
                          .delta = delta,
                          .responses = Eigen::Matrix3d::Identity()});
}

TEST(Transient, OfPulsesIsThatOfTheGoldenValues) {
  int cases = 0;
  for_each_golden("transient_exact", [&](const json& one) {
    if (!one.contains("td")) return;
    ++cases;
    const Eigen::MatrixXd expected = matrix(one.at("x"));
    const Eigen::VectorXd times = vector(one.at("times"));
    for (Eigen::Index i = 0; i < times.size(); ++i) {
      const Transient found = march_transient(jointed(one), pulse(one),
                                              {.duration = times[i], .step = times[i], .responses = Eigen::Matrix3d::Identity()});
      ASSERT_TRUE(found.complete);
      ASSERT_EQ(found.times.size(), 2u);
      EXPECT_LE(difference(found.x.row(1), expected.row(i)), 10.0 * tolerance(one));
      EXPECT_GT(found.events, 0u);
    }
  });
  if (cases == 0) JOINTID_SKIP("no reference file " << golden::file());
}

TEST(Transient, OfTheAlgorithmsComesNearerWithTheStep) {
  const json one = json::parse(R"({"M": [[1.0, 0, 0], [0, 1.2, 0], [0, 0, 0.9]], "p": 18.0, "td": 0.16,
    "C": [[0.5, -0.16, 0], [-0.16, 0.32, -0.04], [0, -0.04, 0.21]], "K": [[500, -200, 0], [-200, 250, -50], [0, -50, 150]],
    "W": [[0], [1], [-1]], "joints": [{"law": "ren", "parameters": [0.004, 1.5, 150]}]})");
  const Transient exact = march(one, TransientMethod::exact, 0.0);
  for (const TransientMethod method : {TransientMethod::algorithm_one, TransientMethod::algorithm_two}) {
    const auto error = [&](double delta) { return (march(one, method, delta).x - exact.x).cwiseAbs().maxCoeff(); };
    const double coarse = error(8e-4), fine = error(2e-4);
    EXPECT_LT(fine, 1e-3 * exact.x.cwiseAbs().maxCoeff());
    EXPECT_LT(fine, coarse / 8.0);
  }
  EXPECT_LE(march(one, TransientMethod::algorithm_two, 2e-4).growth, 1.0);
}

TEST(Transient, IsStoppedByWhoLooksOn) {
  const json one = json::parse(
      R"({"M": [[1.0]], "C": [[0.1]], "K": [[10.0]], "W": [[1]], "joints": [{"law": "bilinear", "parameters": [0.01, 10]}]})");
  TransientRequest request = {.duration = 1.0, .step = 0.1, .responses = Eigen::MatrixXd::Ones(1, 1)};
  request.advance = [](double time) {
    if (time > 0.45) throw std::runtime_error("stop");
  };
  const ForceHistory force = ForceHistory::half_sine(Eigen::VectorXd::Ones(1), 0.2);
  EXPECT_THROW(march_transient(jointed(one), force, request), std::runtime_error);
}

}  // namespace
}  // namespace jointid::response

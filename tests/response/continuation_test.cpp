#include <gtest/gtest.h>

#include "response/continuation/response_curve.hpp"
#include "response/structure/matrix_receptance.hpp"
#include "tests/require.hpp"
#include "tests/response/golden.hpp"

namespace jointid::response {
namespace {

using golden::json;

Eigen::MatrixXd one(double value) { return Eigen::MatrixXd::Constant(1, 1, value); }

TEST(Continuation, FindsTheTurningPointsOfAFold) {
  const auto cases = golden::cases("fold_hb1");
  if (cases.empty()) JOINTID_SKIP("no reference file " << golden::file());
  for (const auto& each : cases) {
    const MatrixStructure structure = {one(each["m"]), one(each["c"]), one(each["k"])};
    const Joint joint = {.name = "joint", .friction = golden::element(each), .cubic = each["k3"]};
    const HarmonicBalance balance(std::make_shared<MatrixReceptance>(structure, one(1.0), one(1.0), one(1.0)), {joint},
                                  Excitation::single(each["P"].get<double>()), {.fixed = {1}});
    CurveRequest request = {.along = Along::frequency, .from = 0.3, .to = 3.0};
    request.longest_step = 0.02;
    const ResponseCurve curve = follow_response(balance, request);
    EXPECT_EQ(curve.end, CurveEnd::reached);
    ASSERT_EQ(curve.turning_points.size(), each["folds"].size());
    const double tolerance = golden::tolerance(each["trusted_digits"]);
    for (const auto& fold : each["folds"]) {
      const double omega = fold["omega"], x = fold["X"];
      bool found = false;
      for (std::size_t i = 0; i < curve.turning_points.size(); ++i) {
        found = found || (std::abs(curve.turning_parameters[i] - omega) <= tolerance * omega &&
                          std::abs(std::abs(curve.turning_points[i].response(0, 0)) - x) <= tolerance * x);
      }
      EXPECT_TRUE(found) << omega << " " << x;
    }
    // The same from the other side.
    std::swap(request.from, request.to);
    EXPECT_EQ(follow_response(balance, request).turning_points.size(), each["folds"].size());
  }
}

HarmonicBalance peak_balance(const json& each, double& level) {
  const MatrixStructure structure = golden::structure(each);
  const Eigen::MatrixXd all = Eigen::MatrixXd::Identity(structure.mass.rows(), structure.mass.rows());
  const auto [numbers, amplitudes] = golden::force(each["P"]);
  level = amplitudes.cwiseAbs().maxCoeff();
  return {std::make_shared<MatrixReceptance>(structure, golden::matrix(each["W"]), all, all),
          golden::joints(each["joints"]),
          {numbers, amplitudes / level},
          {.fixed = golden::integers(each["harmonics"])}};
}

TEST(Continuation, FindsResonancePeaks) {
  const auto cases = golden::cases("resonance_peak");
  if (cases.empty()) JOINTID_SKIP("no reference file " << golden::file());
  for (const auto& each : cases) {
    double level = 1.0;
    const HarmonicBalance balance = peak_balance(each, level);
    CurveRequest request = {.along = Along::frequency, .from = 12.0, .to = 24.0};
    request.level = level;
    const ResponseCurve curve = follow_response(balance, request);
    ASSERT_FALSE(curve.peaks.empty()) << each["id"];
    const auto size = [](const HarmonicSolution& s) { return std::abs(s.response(0, 0)); };
    const HarmonicSolution best = *std::ranges::max_element(curve.peaks, {}, size);
    EXPECT_NEAR(best.omega, each["omega_peak"].get<double>(),
                golden::tolerance(each["trusted_digits"]["omega_peak"]) * best.omega);
    EXPECT_NEAR(size(best), each["X_peak"].get<double>(), golden::tolerance(each["trusted_digits"]["X_peak"]) * size(best));
    // The motion turns as fast as the peak's frequency is known.
    EXPECT_LE(golden::difference(Eigen::VectorXcd(best.joint_motion.col(0)), golden::complex_vector(each["Q"])), 1e-5);
    // Followed over levels and back, the peak is the same.
    const auto peaks = follow_peak(balance, best, {1.05 * level, 1.1 * level, 1.05 * level, level}, 0);
    ASSERT_EQ(peaks.size(), 4u) << each["id"];
    EXPECT_NEAR(peaks.back().omega, best.omega, 1e-7 * best.omega);
    EXPECT_GT(size(peaks[1]), size(peaks[0]));
  }
}

/// Points of a curve are solutions, whatever it is along.
TEST(Continuation, PointsAreThoseOfSingleSolutions) {
  const auto cases = golden::cases("resonance_peak");
  if (cases.empty()) JOINTID_SKIP("no reference file " << golden::file());
  double level = 1.0;
  const HarmonicBalance balance = peak_balance(cases.front(), level);
  CurveRequest request = {.along = Along::level, .from = 0.5, .to = 5.0, .omega = 18.4};
  const ResponseCurve levels = follow_response(balance, request);
  ASSERT_EQ(levels.end, CurveEnd::reached);
  const HarmonicSolution& at = levels.points[levels.points.size() / 2];
  EXPECT_LE(golden::difference(balance.solve(18.4, at.level).response, at.response), 1e-10);

  request = {.along = Along::joint_parameter, .from = 0.004, .to = 0.001, .omega = 18.4, .level = 3.0};
  request.parameter = {0, 0};
  const ResponseCurve slips = follow_response(balance, request);
  ASSERT_EQ(slips.end, CurveEnd::reached);
  const std::size_t middle = slips.points.size() / 2;
  std::vector<double> values = balance.joints()[0].values();
  values[0] = slips.parameters[middle];
  const HarmonicSolution alone = balance.with_joint(0, balance.joints()[0].with(values)).solve(18.4, 3.0);
  EXPECT_LE(golden::difference(alone.response, slips.points[middle].response), 1e-10);
}

}  // namespace
}  // namespace jointid::response

#include "impedance/smooth/spline.hpp"

#include "tests/impedance/golden.hpp"

namespace jointid::impedance {
namespace {

using nlohmann::json;

struct Values {
  std::vector<double> hz;
  Eigen::VectorXcd z;
  Eigen::VectorXd variance;
};

Values values_of(const json& given) {
  Values out{
      given["frequency_Hz"].get<std::vector<double>>(), Eigen::VectorXcd(static_cast<Eigen::Index>(given["z"].size())), {}};
  out.variance.resize(out.z.size());
  for (Eigen::Index q = 0; q < out.z.size(); ++q) {
    out.z(q) = golden::complex(given["z"][static_cast<std::size_t>(q)]);
    out.variance(q) = given["variance"][static_cast<std::size_t>(q)].get<double>();
  }
  return out;
}

void expect_spline(const SplineFit& fit, const json& expected, double tolerance) {
  EXPECT_NEAR(fit.degrees, expected["edf"].get<double>(), tolerance * fit.degrees);
  for (Eigen::Index q = 0; q < fit.z.size(); ++q) {
    const auto k = static_cast<std::size_t>(q);
    EXPECT_LT(std::abs(fit.z(q) - golden::complex(expected["z"][k])), tolerance * 1e5) << q;
    EXPECT_NEAR(fit.variance(q) / expected["variance"][k].get<double>(), 1.0, tolerance) << q;
  }
}

TEST(Spline, GoldenValues) {
  IMPEDANCE_CASE(lines, "siso_laws");
  IMPEDANCE_CASE(smooth, "siso_smooth");
  const Values values = values_of(lines["given"]);
  const json& expected = smooth["expected"]["pspline"];
  const SplineFit fixed =
      fit_spline(values.hz, values.z, values.variance, 12, Smoothing::given, expected["fixed"]["lambda_"].get<double>());
  expect_spline(fixed, expected["fixed"], 1e-9);
  EXPECT_NEAR(fixed.rss, expected["fixed"]["rss"].get<double>(), 1e-9 * fixed.rss);
  EXPECT_NEAR(fixed.marginal, expected["fixed"]["ml"].get<double>(), 1e-9 * fixed.marginal);
  EXPECT_NEAR(fixed.gcv, expected["fixed"]["gcv"].get<double>(), 1e-9);
  EXPECT_NEAR(fixed.cp, expected["fixed"]["cp"].get<double>(), 1e-8);
  for (std::size_t k = 0; k < 12; ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    EXPECT_LT(std::abs(fixed.coefficients(at) - golden::complex(expected["fixed"]["c"][k])), 1e-4);
  }
  EXPECT_NEAR(fixed.variance_sampling(3) / expected["fixed"]["variance_sampling"][3].get<double>(), 1.0, 1e-9);
  for (const auto& [smoothing, key] : {std::pair(Smoothing::marginal, "ml"), {Smoothing::gcv, "gcv"}, {Smoothing::cp, "cp"}}) {
    const SplineFit fit = fit_spline(values.hz, values.z, values.variance, 12, smoothing);
    EXPECT_NEAR(fit.lambda / expected[key]["lambda_"].get<double>(), 1.0, 1e-3) << key;
    EXPECT_NEAR(fit.criterion, expected[key]["criterion"].get<double>(), 1e-9 * fit.criterion) << key;
    expect_spline(fit, expected[key], 1e-3);
  }
}

/// A straight line has no second differences: it comes back whatever λ.
TEST(Spline, AStraightLineStays) {
  Values values{{}, Eigen::VectorXcd(20), Eigen::VectorXd::Constant(20, 0.5)};
  for (Eigen::Index q = 0; q < 20; ++q) {
    values.hz.push_back(10.0 + static_cast<double>(q));
    values.z(q) = Complex(3.0, -1.0) + Complex(0.2, 0.1) * static_cast<double>(q);
  }
  const SplineFit fit = fit_spline(values.hz, values.z, values.variance, 9, Smoothing::given, 1e4);
  EXPECT_LT((fit.z - values.z).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_NEAR(fit.degrees, 2.0, 0.01);
}

}  // namespace
}  // namespace jointid::impedance

#include "impedance/law/law_fit.hpp"

#include "tests/impedance/golden.hpp"

namespace jointid::impedance {
namespace {

using nlohmann::json;

LawLayout one_element() { return {{"z(1,1)"}, {"N/m"}, Eigen::MatrixXd::Ones(1, 1), Eigen::MatrixXd(1, 0), {}, {}}; }

/// Circular errors of one element.
std::optional<LineValue> value_of(Complex z, double variance) {
  LineValue out;
  out.z = Eigen::VectorXcd::Constant(1, z);
  out.covariance = 0.5 * variance * Eigen::MatrixXd::Identity(2, 2);
  return out;
}

std::vector<double> omegas(const json& frequency) {
  std::vector<double> out;
  for (const json& hz : frequency) out.push_back(angular(hz.get<double>()));
  return out;
}

TEST(LawFit, SevenLawsOfTheLinesOfSiso) {
  IMPEDANCE_CASE(golden, "siso_laws");
  const json& given = golden["given"];
  std::vector<std::optional<LineValue>> lines;
  for (std::size_t i = 0; i < given["z"].size(); ++i)
    lines.push_back(value_of(golden::complex(given["z"][i]), given["variance"][i].get<double>()));
  std::vector<LawKind> all;
  for (std::size_t k = 0; k < law_names().size(); ++k) all.push_back(static_cast<LawKind>(k));
  const std::vector<LawFit> fits = fit_laws(all, one_element(), omegas(given["frequency_Hz"]), lines);
  EXPECT_EQ(fits.front().law, LawKind::fractional_zener);
  for (const LawFit& fit : fits) {
    std::string key = name(fit.law);
    std::ranges::replace(key, '-', '_');
    const json& expected = golden["expected"][key];
    ASSERT_TRUE(fit.converged) << key;
    EXPECT_NEAR(fit.chi_square, expected["chi2"].get<double>(), 1e-9 * fit.chi_square) << key;
    EXPECT_EQ(fit.freedom, expected["degrees"].get<double>());
    EXPECT_NEAR(fit.aic, expected["aic"].get<double>(), 1e-9 * fit.aic);
    for (std::size_t k = 0; k < expected["theta"].size(); ++k) {
      const auto at = static_cast<Eigen::Index>(k);
      const double deviation = std::sqrt(expected["covariance"][k][k].get<double>());
      EXPECT_NEAR(fit.theta(at), expected["theta"][k].get<double>(), 1e-6 * deviation) << key << k;
      EXPECT_NEAR(std::sqrt(fit.covariance(at, at)) / deviation, 1.0, 1e-6) << key << k;
    }
  }
}

/// §11: a law with masses on the whole matrices of the lines, weighed by all of their covariances.
TEST(LawFit, WithMassesOnWholeMatrices) {
  IMPEDANCE_CASE(golden, "siso_mass");
  golden::LinesCase given = golden::lines_case(golden["given"]);
  const IdentifiedLines found =
      identify_lines(golden::scene_of(given.dofs,
                                      "lines = \"symmetric\"\nlaws = [\"fractional-zener\"]\nlaw_masses = true\n"
                                      "facing = [[\"2:+Y\", \"3:+Y\"]]"),
                     std::move(given.substructures), std::move(given.assembly));
  ASSERT_EQ(found.laws.size(), 1U);
  const LawFit& fit = found.laws.front();
  const json& expected = golden["law_on_lines"];
  for (std::size_t k = 0; k < expected["theta"].size(); ++k) {
    const double deviation = std::sqrt(expected["covariance"][k][k].get<double>());
    EXPECT_NEAR(fit.parameters[k].value, expected["theta"][k].get<double>(), 1e-5 * deviation) << fit.parameters[k].name;
    EXPECT_NEAR(fit.parameters[k].std_error / deviation, 1.0, 1e-5) << fit.parameters[k].name;
    EXPECT_NEAR(fit.parameters[k].value, golden["direct_likelihood"]["theta"][k].get<double>(), 0.06 * deviation);  // §6
  }
}

TEST(LawFit, TheChosenLawIsTold) {
  IMPEDANCE_CASE(golden, "siso");
  golden::LinesCase given = golden::lines_case(golden["given"]);
  const IdentifiedLines found = identify_lines(golden::scene_of(given.dofs, "lines = \"massless\"\nlaws = \"all\""),
                                               std::move(given.substructures), std::move(given.assembly));
  EXPECT_EQ(found.status, Status::ok) << found.message;
  ASSERT_EQ(found.laws.size(), 7U);
  EXPECT_EQ(found.laws.front().law, LawKind::fractional_zener);
  EXPECT_EQ(found.laws[1].law, LawKind::quadratic);
  EXPECT_NEAR(found.laws[1].aic - found.laws[0].aic, 29.36, 0.01);
}

TEST(LawFit, SlopesAreThoseOfDifferences) {
  for (std::size_t k = 0; k < law_names().size(); ++k) {
    const auto law = static_cast<LawKind>(k);
    Eigen::VectorXd theta(static_cast<Eigen::Index>(parameters_of(law, "N/m").size()));
    const std::vector<double> values = {3e4, 9e4, 2e-3, 0.6};
    for (Eigen::Index i = 0; i < theta.size(); ++i) theta(i) = shape_count(law) > 0 ? values[static_cast<std::size_t>(i)] : 1e4;
    const LawValue here = law_value(law, 300.0, theta);
    for (Eigen::Index i = 0; i < theta.size(); ++i) {
      const double step = 1e-5 * theta(i);
      Eigen::VectorXd up = theta, down = theta;
      up(i) += step;
      down(i) -= step;
      const Complex slope = (law_value(law, 300.0, up).z - law_value(law, 300.0, down).z) / (2.0 * step);
      EXPECT_LT(std::abs(slope - here.slope(i)), 1e-6 * std::abs(slope) + 1e-9) << name(law) << i;
    }
  }
}

}  // namespace
}  // namespace jointid::impedance

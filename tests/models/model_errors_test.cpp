#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "ident/identify.hpp"
#include "ident/likelihood/data/scaled_part.hpp"
#include "ident/scene/read_scene.hpp"
#include "models/model_file.hpp"
#include "problems/problem.hpp"
#include "scene/text.hpp"
#include "tests/models/model_sample.hpp"
#include "tests/test_folder.hpp"

namespace jointid::ident {
namespace {

using ::testing::HasSubstr;

/// A1, whose second part is a model, b.toml, with other stiffness and mass than the part that was measured.
class ModelErrors : public testing::Test {
 protected:
  void describe(double stiffness, double mass, const std::string& more) const {
    const problems::Structure part = problems::substructure_b();
    models::write_market(folder_ / "m.mtx", mass * models::sparse_matrix(part, problems::Kind::mass));
    models::write_market(folder_ / "k.mtx", stiffness * models::sparse_matrix(part, problems::Kind::stiffness));
    models::write_text(folder_ / "b.toml", "mass = \"m.mtx\"\nstiffness = \"k.mtx\"\nloss_factor = 0.001\n" + more +
                                               "dofs = " + models::dof_list(part.dofs()) + "\n");
  }

  Scene scene(const std::string& method, bool clean = false) const {
    std::string text = scene::read_text(
        problems::write(problems::make("A1"), folder_, {.format = "h5", .seed = 1, .method = method, .clean = clean}));
    const std::string from = "A1_substructure_2.h5";
    text.replace(text.find(from), from.size(), "b.toml");
    return parse_scene(text, folder_ / "scene.toml");
  }

  Solution solved(const std::string& method = "likelihood") const { return solve(*make_plan(scene(method))); }

  models::ModelError error_of(const std::string& keys) const {
    describe(1.0, 1.0, keys);
    return models::error_of_model(folder_ / "b.toml");
  }

  TestFolder folder_;
};

/// How many standard errors each stiffness is off.
std::vector<double> stiffness_errors(const Solution& found) {
  const problems::Problem problem = problems::make("A1");
  std::vector<double> out;
  for (std::size_t u = 0; u < problem.unknowns.size(); ++u) {
    if (problem.unknowns[u].name[0] != 'K') continue;
    out.push_back((found.unknowns[u].value - problem.unknowns[u].value) / found.unknowns[u].std_error.value());
  }
  return out;
}

double sum_of_squares(const std::vector<double>& all) {
  double sum = 0.0;
  for (const double each : all) sum += each * each;
  return sum;
}

TEST_F(ModelErrors, AreReadWholeOrByBands) {
  const models::ModelError whole = error_of("stiffness_error = 0.02\nmass_error = 0.0\n");
  ASSERT_EQ(whole.stiffness.size(), 1u);
  EXPECT_EQ(whole.stiffness[0].deviation, 0.02);
  EXPECT_TRUE(whole.stiffness[0].has(1e6));
  EXPECT_TRUE(whole.mass.empty());
  const models::ModelError bands =
      error_of("mass_error = [{ range = [0, 500], error = 0.01 }, { range = [500, 800], error = 0.03 }]\n");
  ASSERT_EQ(bands.mass.size(), 2u);
  EXPECT_TRUE(bands.mass[0].has(499.9) && !bands.mass[0].has(500.0) && bands.mass[1].has(500.0));
  EXPECT_FALSE(error_of("").any());
}

TEST_F(ModelErrors, ThatCannotBeAreRefused) {
  for (const char* keys : {"stiffness_error = 1.5\n", "stiffness_error = []\n", "mass_error = [{ range = [0, 500] }]\n",
                           "mass_error = [{ range = [0, 500], error = 0.1 }, { range = [400, 800], error = 0.1 }]\n"}) {
    EXPECT_THROW(error_of(keys), InputError) << keys;
    EXPECT_THROW(models::read_model(folder_ / "b.toml"), InputError) << keys;
  }
}

/// Against a model whose matrices are scaled.
TEST_F(ModelErrors, ScaleAPartExactly) {
  constexpr double s = 0.05, m = -0.03, hz = 431.0, beside = 1e-5;
  describe(1.0, 1.0, "");
  const std::vector<frf::Dof> dofs = problems::substructure_b().dofs();
  ScaledPart part({folder_ / "b.toml", {}}, dofs, {100.0, 1000.0});
  const ScaledPart::Values found = part.at(hz, s, m);
  std::vector<std::size_t> all(dofs.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  const auto expected = [&](double stiffness, double mass) {
    describe(std::exp(stiffness), std::exp(mass), "");
    const models::NamedModel model = models::read_model(folder_ / "b.toml");
    return *model.model->receptance(angular(hz), all, all);
  };
  const auto expect_near = [](const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b, double tolerance) {
    EXPECT_LE((a - b).cwiseAbs().maxCoeff(), tolerance * b.cwiseAbs().maxCoeff());
  };
  expect_near(found.h, expected(s, m), 1e-10);
  expect_near(found.by_stiffness, (expected(s + beside, m) - expected(s - beside, m)) / (2.0 * beside), 1e-5);
  expect_near(found.by_mass, (expected(s, m + beside) - expected(s, m - beside)) / (2.0 * beside), 1e-5);
}

TEST_F(ModelErrors, AreFoundWithTheJoint) {
  describe(1.0 / 1.02, 1.0, "stiffness_error = 0.02\nmass_error = 0.01\n");
  const Solution found = solved();
  ASSERT_EQ(found.systematic.size(), 2u);
  EXPECT_EQ(found.systematic[0].name, "stiffness of b.toml");
  EXPECT_EQ(found.systematic[0].prior_deviation, 0.02);
  EXPECT_NEAR(found.systematic[0].value, 1.02, 5.0 * found.systematic[0].std_error.value());
  EXPECT_LE(found.systematic[0].std_error.value(), 0.002);
  EXPECT_NEAR(found.systematic[1].value, 1.0, 5.0 * found.systematic[1].std_error.value());
  EXPECT_LE(sum_of_squares(stiffness_errors(found)), 40.0);  // χ² of 10 degrees of freedom
  ASSERT_TRUE(found.identifiability);
  EXPECT_EQ(found.identifiability->calibration.size(), found.unknowns.size());
}

TEST_F(ModelErrors, ThatAreNotStatedMakeTheJointWrong) {
  describe(1.0 / 1.02, 1.0, "");
  const Solution found = solved();
  EXPECT_NE(found.status, Status::ok);
  EXPECT_TRUE(found.systematic.empty());
}

TEST_F(ModelErrors, BeyondWhatIsStatedAreNamed) {
  describe(1.0 / 1.02, 1.0, "stiffness_error = 0.004\nmass_error = 0.004\n");
  const Solution found = solved();
  EXPECT_NE(found.status, Status::ok);
  EXPECT_THAT(found.message, HasSubstr("The data call for a stiffness of b.toml of 1.0"));
}

TEST_F(ModelErrors, OfBandsAreUnknownsEach) {
  describe(1.0, 1.0, "stiffness_error = [{ range = [0, 700], error = 0.01 }, { range = [700, 2000], error = 0.02 }]\n");
  const Solution found = solved();
  ASSERT_EQ(found.systematic.size(), 2u);
  EXPECT_EQ(found.systematic[1].name, "stiffness of b.toml from 700 to 2000 Hz");
}

TEST_F(ModelErrors, AreWarnedOfWhereTheyAreNotEstimated) {
  describe(1.0, 1.0, "stiffness_error = 0.02\n");
  EXPECT_THAT(make_plan(scene("one"))->warnings, testing::Contains(HasSubstr("models for exact")));
}

TEST_F(ModelErrors, AreOfPartsAlone) {
  describe(1.0, 1.0, "stiffness_error = 0.02\n");
  Scene both = scene("likelihood");
  both.data.assembly = {{folder_ / "b.toml", {}}};
  EXPECT_THROW(make_plan(both), InputError);
}

}  // namespace
}  // namespace jointid::ident

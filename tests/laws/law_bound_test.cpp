#include "laws/task/law_bound.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "dense/cholesky.hpp"
#include "friction/law/laws.hpp"
#include "laws/scene/read_law_scene.hpp"
#include "laws/task/identify_laws.hpp"
#include "problems/vibration/law_problem_cases.hpp"
#include "response/harmonic/harmonic_balance.hpp"
#include "tests/test_folder.hpp"

namespace jointid::laws {
namespace {

using testing::HasSubstr;

constexpr const char* iwan_joint = "[[joint.friction]]\nname = \"slot\"\ndofs = [\"1:+Y\"]\n";

/// Parts of a problem, and planned levels with these amplitudes.
std::string planned_text(const std::filesystem::path& part, const std::vector<double>& amplitudes, const std::string& joint,
                         const std::string& harmonics = "[1, 3]") {
  std::string text = "[data]\nparts = [\"" + part.filename().string() + "\"]\n";
  for (const double amplitude : amplitudes) {
    text += "[[data.levels]]\namplitude = " + std::to_string(amplitude) + "\nforce_dofs = [\"1:+Y\"]\nharmonics = " + harmonics + "\n";
  }
  return text + joint + "[frequency]\nrange = [80.0, 135.0]\n[errors]\nrelative = 0.01\n";
}

std::string error_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

class LawBoundScene : public testing::Test {
 protected:
  LawBoundScene() { problems::write(problems::make_law_problem("sdof-iwan"), folder_, {.clean = true}); }
  LawScene scene(const std::string& text) const { return parse_law_scene(text, folder_ / "plan.toml"); }
  std::filesystem::path part() const { return folder_ / "sdof-iwan_part_1.h5"; }

  TestFolder folder_;
};

/// Against the information from central differences of harmonic balance, of parts that are exact.
TEST_F(LawBoundScene, IsTheInverseOfTheInformation) {
  const std::vector<double> truth = {1e-5, 4e5};
  const std::string joint = std::string(iwan_joint) + "law = \"bilinear\"\nassumed = { a = 1e-5, k = 4e5 }\n";
  LawScene planned = scene(planned_text(part(), {4.0, 20.0}, joint));
  planned.harmonics = {1, 3, 5};
  const LawBound bound = predict_law_bound(planned);
  ASSERT_EQ(bound.all.joints.size(), 1u);
  EXPECT_EQ(word(bound.all.status), "converged");
  const LevelStates data = read_level_states(planned);
  const auto responses = [&](const std::vector<double>& values, const response::MeasuredState& state) {
    const response::Joint law = {.name = "slot", .friction = friction::make_element("bilinear", values)};
    const auto solved = response::HarmonicBalance(data.structure, {law}, state.force, {.fixed = {1, 3, 5}}).solve(state.omega);
    EXPECT_TRUE(solved.converged);
    return Eigen::VectorXcd(solved.response.col(0).head(2));
  };
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(2, 2);
  for (const response::MeasuredState& state : data.states) {
    const Eigen::VectorXcd at_truth = responses(truth, state);
    const double largest = at_truth.cwiseAbs().maxCoeff();
    Eigen::MatrixXcd slopes(2, 2);
    for (Eigen::Index p = 0; p < 2; ++p) {
      const std::size_t i = static_cast<std::size_t>(p);
      std::vector<double> up = truth, down = truth;
      up[i] *= 1.0 + 1e-6;
      down[i] *= 1.0 - 1e-6;
      slopes.col(p) = (responses(up, state) - responses(down, state)) / (2e-6 * truth[i]);
    }
    for (Eigen::Index n = 0; n < 2; ++n) {
      const double variance = 0.5 * std::pow(0.01 * std::max(std::abs(at_truth(n)), 1e-3 * largest), 2);
      information += (slopes.row(n).adjoint() * slopes.row(n)).real() / variance;
    }
  }
  const Eigen::Vector2d scale = information.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * information * scale.asDiagonal();
  const Eigen::MatrixXd covariance = scale.asDiagonal() * dense::solve_positive(scaled, Eigen::MatrixXd(Eigen::MatrixXd::Identity(2, 2))) *
                                     scale.asDiagonal();
  for (Eigen::Index p = 0; p < 2; ++p) {
    const friction::FittedValue& value = bound.all.joints[0].parameters[static_cast<std::size_t>(p)];
    ASSERT_TRUE(value.std_error);
    EXPECT_NEAR(*value.std_error / std::sqrt(covariance(p, p)), 1.0, 1e-3) << value.name;
  }
}

/// What solve tells of levels that were measured is what was predicted for them, their own laws being found first.
TEST_F(LawBoundScene, OfMeasuredLevelsIsWhatSolveTells) {
  LawScene measured = read_law_scene(folder_ / "sdof-iwan.toml");
  measured.joints[0].laws = {"iwan"};
  measured.harmonics = {1, 3, 5, 7};
  const LawIdentification found = identify_laws(measured);
  const LawBound bound = predict_law_bound(measured);
  EXPECT_FALSE(bound.assumed);
  EXPECT_EQ(bound.measured, measured.levels.size());
  EXPECT_TRUE(bound.worth.empty());
  ASSERT_EQ(bound.present.joints.size(), 1u);
  EXPECT_NEAR(*bound.present.joints[0].stiffness.std_error / *found.fit().joints[0].stiffness.std_error, 1.0, 0.02);
  EXPECT_NEAR(*bound.present.joints[0].limit.std_error / *found.fit().joints[0].limit.std_error, 1.0, 0.02);
}

TEST_F(LawBoundScene, RanksLevelsAndSaysWhatTheyDoNotShow) {
  const std::string joint = std::string(iwan_joint) + "law = \"bilinear\"\nassumed = { a = 1e-5, k = 4e5 }\n";
  const LawBound low = predict_law_bound(scene(planned_text(part(), {0.01, 0.02}, joint)));
  EXPECT_THAT(low.all.unseen, testing::Contains(HasSubstr("slot: the friction limit is not seen")));
  const LawBound three = predict_law_bound(scene(planned_text(part(), {0.01, 20.0, 0.02}, joint)));
  EXPECT_TRUE(three.all.unseen.empty());
  ASSERT_EQ(three.worth.size(), 3u);
  EXPECT_EQ(three.worth[0].level, 1u);  // without it nothing slips
  EXPECT_THAT(three.worth[0].bound.unseen, testing::Contains(HasSubstr("not seen")));
  EXPECT_LE(three.all.size, three.worth[1].bound.size);
}

TEST_F(LawBoundScene, SaysWhatIsMissing) {
  const std::string joint = std::string(iwan_joint) + "law = \"bilinear\"\n";
  const std::string text = planned_text(part(), {1.0}, joint);
  EXPECT_THAT(error_of([&] { predict_law_bound(scene(text)); }), HasSubstr("nothing states what laws the plan is for"));
  EXPECT_THAT(error_of([&] { identify_laws(scene(text)); }), HasSubstr("nothing was measured"));
  const std::string assumed = planned_text(part(), {1.0}, joint + "assumed = { a = 1e-5, k = 4e5 }\n");
  EXPECT_THAT(error_of([&] {
                LawScene without = scene(assumed);
                without.errors.reset();
                predict_law_bound(without);
              }),
              HasSubstr("nothing states how exact a planned level will be"));
  EXPECT_THAT(error_of([&] { scene(planned_text(part(), {1.0}, joint + "assumed = { a = 1e-5 }\n")); }), HasSubstr("k"));
  EXPECT_THAT(error_of([&] { scene(planned_text(part(), {1.0}, std::string(iwan_joint) + "assumed = { a = 1e-5 }\n")); }),
              HasSubstr("which of several laws"));
}

}  // namespace
}  // namespace jointid::laws

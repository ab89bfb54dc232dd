#include <gmock/gmock.h>

#include <Eigen/Core>
#include <cmath>

#include "ident/likelihood/findings/findings.hpp"
#include "ident/likelihood/findings/weak_combinations.hpp"
#include "tests/ident/likelihood_case.hpp"

namespace jointid::ident {
namespace {

using restrictions::Kind;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(WeakCombinations, TwoThatMoveTogetherAreTold) {
  // Relative errors a + b = 1.2·√2 and a − b = 0.003·√2 of a and b, and 0.01 of c.
  Eigen::Matrix3d covariance;
  const double sum = 1.2 * 1.2, difference = 0.003 * 0.003;
  covariance << 0.5 * (sum + difference), 0.5 * (sum - difference), 0.0,  //
      0.5 * (sum - difference), 0.5 * (sum + difference), 0.0,            //
      0.0, 0.0, 1e-4;
  const auto weak = weak_combinations(covariance, {"a", "b", "c"});
  ASSERT_EQ(weak.size(), 2u);
  EXPECT_THAT(weak[0].worst.names, ElementsAre("a", "b"));
  EXPECT_NEAR(weak[0].worst.deviation, 1.2, 1e-12);
  EXPECT_NEAR(weak[0].best->deviation, 0.003, 1e-9);
  EXPECT_GT(*weak[0].correlation, 0.9999);
  EXPECT_EQ(text(weak[0]), "a and b move together (correlation 1.000): relative to their sizes the data fix a - b to 0.3 %, but a "
                           "+ b only to 120 %.");
  EXPECT_THAT(weak[1].worst.names, ElementsAre("c"));
  EXPECT_EQ(text(weak[1]), "c is known only to 1 %.");
}

TEST(WeakCombinations, TheDeviationIsThatOfTheCombination) {
  Eigen::MatrixXd root = Eigen::MatrixXd::Random(5, 5);
  const Eigen::MatrixXd covariance = root * root.transpose();
  const std::vector<std::string> names = {"0", "1", "2", "3", "4"};
  for (const WeakCombination& weak : weak_combinations(covariance, names)) {
    Eigen::VectorXd v = Eigen::VectorXd::Zero(5);
    for (std::size_t i = 0; i < weak.worst.names.size(); ++i) v[std::stoi(weak.worst.names[i])] = weak.worst.factors[i];
    EXPECT_NEAR(v.norm(), 1.0, 1e-12);
    EXPECT_NEAR(std::sqrt(v.dot(covariance * v)), weak.worst.deviation, 1e-12);
  }
}

TEST(Findings, MisfitNamesTheWorstLines) {
  Fit fit;
  fit.chi_square = ChiSquare{.value = 200.0, .degrees_of_freedom = 50.0, .outlying_lines = 0, .by_line = {1.0, 9.0, 0.5, 4.0}};
  const auto found = findings_of({}, fit, IntervalKind::cramer_rao, {10.0, 20.0, 30.0, 40.0});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, FindingKind::misfit);
  EXPECT_THAT(found[0].text, HasSubstr("20 Hz (9) and 40 Hz (4)"));
  fit.chi_square->value = 100.0;
  EXPECT_TRUE(findings_of({}, fit, IntervalKind::cramer_rao, {10.0, 20.0, 30.0, 40.0}).empty());
}

TEST(Identifiability, AGoodTestFindsNothing) {
  const Solution solution = solve(*LikelihoodCase("F3", 0.01).polluted());
  ASSERT_TRUE(solution.identifiability);
  EXPECT_EQ(solution.intervals, IntervalKind::cramer_rao);
  EXPECT_LT(solution.identifiability->largest_relative_error, 0.1);
  EXPECT_THAT(solution.identifiability->findings, ::testing::IsEmpty());
}

TEST(Identifiability, ASoftJointIsToldWithItsRemedy) {
  const Solution solution = solve(*LikelihoodCase("C1").polluted());
  EXPECT_TRUE(tells(solution, FindingKind::soft_joint));
  EXPECT_TRUE(tells(solution, FindingKind::weak_combination));
  EXPECT_FALSE(tells(solution, FindingKind::stiff_joint));
  EXPECT_FALSE(tells(solution, FindingKind::misfit));
}

TEST(Identifiability, AStiffJointIsToldWithItsRemedy) {
  const Solution solution = solve(*LikelihoodCase("E1", 0.2).polluted(3));
  EXPECT_TRUE(tells(solution, FindingKind::stiff_joint));
  EXPECT_FALSE(tells(solution, FindingKind::soft_joint));
}

TEST(Identifiability, UnknownsInOnePlaceAreRankDeficient) {
  LikelihoodCase a1("A1", 0.01);
  a1.scene.joints[0].matrices = {{Kind::stiffness, restrictions::EntryMatrix{{"a+b", "c", "-a-b", "c"},
                                                                            {"c", "d", "-c", "e"},
                                                                            {"-a-b", "-c", "a+b", "-c"},
                                                                            {"c", "e", "-c", "d"}}}};
  a1.scene.truth.clear();
  const Solution solution = solve(*a1.polluted());
  EXPECT_EQ(solution.status, Status::rank_deficient);
  EXPECT_THAT(solution.message, HasSubstr("move together"));
  ASSERT_EQ(solution.unknowns.size(), 5u);
  for (const Estimate& estimate : solution.unknowns) {
    const bool free = estimate.name == "K.a" || estimate.name == "K.b";
    EXPECT_EQ(estimate.determined, !free) << estimate.name;
    EXPECT_EQ(estimate.std_error.has_value(), !free) << estimate.name;
  }
}

TEST(Identifiability, WrongVariancesAreToldAsMisfit) {
  LikelihoodCase a1("A1", 0.05);
  a1.scene.noise->level = a1.scene.noise->frf_model.level = 0.01;
  const Solution solution = solve(*a1.polluted());
  EXPECT_TRUE(tells(solution, FindingKind::misfit));
}

}  // namespace
}  // namespace jointid::ident

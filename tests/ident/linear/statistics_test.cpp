#include <gtest/gtest.h>

#include "base/statistics.hpp"
#include "ident/identify.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"

namespace jointid::ident {
namespace {

using restrictions::Kind;
using weighting::Weighting;

constexpr std::size_t trials = 50;

/// Median over noisy data sets of the rms relative error of the elements of a matrix (thesis Table 6.3).
struct Medians {
  double stiffness = 0.0, damping = 0.0;
};

Medians medians(const std::string& name, Weighting weighting) {
  const problems::Problem problem = problems::make(name);
  Scene scene = problems::scene(problem);
  scene.identify.weighting = weighting;
  std::vector<double> stiffness, damping;
  for (std::size_t trial = 0; trial < trials; ++trial) {
    const auto plan = problems::plan(scene, problems::polluted(problem, 63, trial));
    const Solution solution = solve(*plan);
    EXPECT_EQ(solution.status, Status::ok);
    stiffness.push_back(solution.quality.at(Kind::stiffness).rms_relative_error);
    damping.push_back(solution.quality.at(Kind::hysteretic_damping).rms_relative_error);
  }
  return {median(stiffness), median(damping)};
}

TEST(Statistics, WeightingHelpsByAFactorOfFiveInCaseA1) {
  const Medians none = medians("A1", Weighting::none), wa = medians("A1", Weighting::wa), wb = medians("A1", Weighting::wb);
  EXPECT_GE(none.stiffness, 5.0 * wa.stiffness);
  EXPECT_GE(none.damping, 5.0 * wa.damping);
  EXPECT_GE(none.stiffness, 5.0 * wb.stiffness);
  // An independent program has 0.79, 0.09 and 0.09 for K, and 40 and 1.3 to 1.6 for D.
  EXPECT_NEAR(none.stiffness, 0.79, 0.25);
  EXPECT_NEAR(wa.stiffness, 0.09, 0.03);
  EXPECT_NEAR(wb.stiffness, 0.09, 0.03);
  EXPECT_NEAR(wa.damping, 1.45, 0.5);
}

TEST(Statistics, MethodTwoIsTheWorseOne) {
  const Medians one = medians("A1", Weighting::wa), two = medians("A11", Weighting::wa);
  EXPECT_GT(two.stiffness, 2.0 * one.stiffness);
  EXPECT_GT(two.damping, 2.0 * one.damping);
}

TEST(Statistics, RestrictionsAndMoreLinesHelp) {
  const Medians a1 = medians("A1", Weighting::wa);
  EXPECT_LT(medians("A10", Weighting::wa).stiffness, medians("A9", Weighting::wa).stiffness);
  EXPECT_LT(medians("A9", Weighting::wa).stiffness, a1.stiffness);
  EXPECT_LT(medians("A5", Weighting::wa).stiffness, a1.stiffness);
}

}  // namespace
}  // namespace jointid::ident

#include "tasks/worth.hpp"

#include <gmock/gmock.h>

#include "base/control.hpp"
#include "ident/identify.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"

namespace jointid::tasks {
namespace {

using testing::HasSubstr;

/// Exact FRFs of a joint of two DOFs with rotation, and its solution, of which each test spoils one thing.
struct Solved {
  problems::Problem problem = problems::make("A1");
  std::unique_ptr<ident::Plan> plan =
      ident::make_plan(problems::scene(problem), problem.substructures, {problem.assembly});
  ident::Solution solution = ident::solve(*plan);

  WorthAnswer answer(WorthQuestion question) const {
    const std::vector<WorthAnswer> answers = worth(*plan, solution);
    EXPECT_EQ(answers.size(), 4U);
    const WorthAnswer& found = answers.at(static_cast<std::size_t>(question));
    EXPECT_EQ(found.question, question);
    return found;
  }
  ident::Matrix& stiffness() { return solution.bands.front().matrices.at(restrictions::Kind::stiffness); }
  void set_errors(double share) {
    for (ident::Estimate& each : solution.unknowns) each.error_estimate = share * std::abs(each.value);
  }
};

TEST(Worth, OfTheExactJointOnExactDataNothingIsDoubted) {
  Solved solved;
  solved.set_errors(0.01);
  solved.solution.fit.misfit = 1.0;
  for (const WorthAnswer& answer : worth(*solved.plan, solved.solution)) {
    EXPECT_EQ(answer.light, Light::good) << answer.text;
    EXPECT_THAT(answer.text, testing::EndsWith("."));
  }
}

TEST(Worth, NamesTheUnknownThatTheDataDoNotDetermine) {
  Solved solved;
  solved.solution.unknowns.at(2).determined = false;
  const WorthAnswer answer = solved.answer(WorthQuestion::determined);
  EXPECT_EQ(answer.light, Light::bad);
  EXPECT_EQ(answer.unknown, solved.solution.unknowns.at(2).name);
  EXPECT_THAT(answer.text, HasSubstr("1 of " + std::to_string(solved.solution.unknowns.size())));
}

TEST(Worth, DoubtsAnUnknownWhoseIntervalIsWiderThanItsValue) {
  Solved solved;
  solved.set_errors(0.01);
  ident::Estimate& wide = solved.solution.unknowns.at(1);
  wide.ci95 = {{wide.value - 3.0 * std::abs(wide.value), wide.value + 3.0 * std::abs(wide.value)}};
  const WorthAnswer answer = solved.answer(WorthQuestion::determined);
  EXPECT_EQ(answer.light, Light::doubtful);
  EXPECT_EQ(answer.unknown, wide.name);
}

TEST(Worth, WithoutErrorsItIsNotKnownWhatIsDetermined) {
  Solved solved;
  for (ident::Estimate& each : solved.solution.unknowns) {
    each.error_estimate.reset();
    each.ci95.reset();
  }
  EXPECT_EQ(solved.answer(WorthQuestion::determined).light, Light::unknown);
}

/// A diagonal element below zero: no spring is that. It is certain when the errors are small.
TEST(Worth, FindsTheCoordinateAtWhichAJointIsNotPassive) {
  Solved solved;
  solved.stiffness()[2][2] = -std::abs(solved.stiffness()[2][2]);
  for (const auto& [share, light] : {std::pair(0.001, Light::bad), std::pair(10.0, Light::doubtful)}) {
    solved.set_errors(share);
    const WorthAnswer answer = solved.answer(WorthQuestion::passive);
    EXPECT_EQ(answer.light, light) << share << answer.text;
    ASSERT_TRUE(answer.element);
    EXPECT_EQ(answer.element->kind, restrictions::Kind::stiffness);
    EXPECT_EQ(answer.element->row, 2U);
    EXPECT_THAT(answer.text, HasSubstr(solved.solution.dofs.at(2).name()));
  }
}

TEST(Worth, HoldsTheResidualsAgainstTheNoise) {
  Solved solved;
  solved.solution.fit.misfit.reset();
  solved.solution.fit.chi_square.reset();
  EXPECT_EQ(solved.answer(WorthQuestion::noise).light, Light::unknown);
  solved.solution.fit.chi_square = ident::ChiSquare{.value = 100.0, .degrees_of_freedom = 100.0, .by_line = {}, .likely = 1.2};
  EXPECT_EQ(solved.answer(WorthQuestion::noise).light, Light::good);
  solved.solution.fit.chi_square->value = 190.0;
  EXPECT_EQ(solved.answer(WorthQuestion::noise).light, Light::doubtful);
  solved.solution.fit.chi_square->value = 900.0;
  const WorthAnswer answer = solved.answer(WorthQuestion::noise);
  EXPECT_EQ(answer.light, Light::bad);
  EXPECT_THAT(answer.text, HasSubstr("3 times"));
  EXPECT_TRUE(answer.frf);
}

/// No joint at all is as good as none; one with the sign of its stiffness turned is worse.
TEST(Worth, ComparesTheJointWithNone) {
  Solved solved;
  EXPECT_EQ(solved.answer(WorthQuestion::better_than_none).light, Light::good);
  for (auto& [kind, matrix] : solved.solution.bands.front().matrices) {
    for (std::vector<double>& row : matrix) std::ranges::fill(row, 0.0);
  }
  EXPECT_EQ(solved.answer(WorthQuestion::better_than_none).light, Light::bad);
}

TEST(Worth, SaysWhatTheDataDoNotShow) {
  Solved solved;
  solved.solution.identifiability = ident::Identifiability{};
  solved.solution.identifiability->joint.effect = 0.7;
  EXPECT_EQ(solved.answer(WorthQuestion::better_than_none).light, Light::bad);
}

TEST(Worth, CanBeInterrupted) {
  const Solved solved;
  ident::Control control;
  control.interrupted = [] { return true; };
  EXPECT_THROW(worth(*solved.plan, solved.solution, control), Interrupted);
}

}  // namespace
}  // namespace jointid::tasks

#include "response/identify/law_choice.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "tests/response/measured_masses.hpp"

namespace jointid::response {
namespace {

const std::vector<double> levels = {1.0, 3.0, 8.0, 16.0}, omegas = {18.4, 19.0, 19.6, 20.2, 20.8};

struct Truth {
  const char* law;
  std::vector<double> values;
};
const std::vector<Truth> truths = {
    {"bilinear", {0.006, 200.0}}, {"ren", {0.004, 1.5, 150.0}}, {"shoukry", {1.2, 120.0}}, {"iwan", {1.4, 240.0, -0.4, 0.5}}};

std::vector<Joint> joint_of(const Truth& truth) { return {{.name = "joint", .friction = law(truth.law, truth.values)}}; }

const std::vector<Joint> nothing_beside = {{.name = "joint"}};

/// The forces of many harmonics without noise give the law back; of few, something near it.
TEST(LawStart, IsNearTheTruth) {
  for (const Truth& truth : truths) {
    const auto states = measure(masses(1), joint_of(truth), levels, omegas);
    ASSERT_FALSE(states.empty());
    const std::vector<Joint> start = law_starts(*masses(1), states, {truth.law}, nothing_beside).front();
    const double stiffness = start[0].stuck_stiffness() / joint_of(truth)[0].stuck_stiffness();
    EXPECT_NEAR(stiffness, 1.0, 0.05) << truth.law;
    EXPECT_NEAR(start[0].friction->limit() / joint_of(truth)[0].friction->limit(), 1.0, 0.05) << truth.law;
  }
}

/// Of every stretch of lines the one at the share, with all its levels; of too few lines none.
TEST(SomeLines, AreEvenlyAmongAll) {
  std::vector<MeasuredState> states;
  for (int line = 0; line < 12; ++line) {
    MeasuredState state;
    state.omega = 100.0 - line;  // falling
    states.insert(states.end(), 2, state);
  }
  const auto chosen = [&](std::size_t count, double share) {
    std::vector<double> omegas;
    for (const MeasuredState& state : some_lines(states, count, share)) omegas.push_back(state.omega);
    return omegas;
  };
  EXPECT_EQ(chosen(3, 0.5), (std::vector<double>{99, 99, 95, 95, 91, 91}));
  EXPECT_EQ(chosen(3, 0.25), (std::vector<double>{98, 98, 94, 94, 90, 90}));
  EXPECT_EQ(chosen(6, 0.75).size(), 12u);
  EXPECT_TRUE(chosen(7, 0.5).empty());
}

/// From data alone, also where one of the starts leads Iwan's β to 0 and stays there.
TEST(LawStart, LeadsToTheMinimum) {
  std::mt19937_64 generator(1003);
  for (const Truth& truth : truths) {
    const auto states = noisy(measure(masses(1), joint_of(truth), levels, omegas), generator);
    const LawFitOptions options = {.harmonics = {1, 3, 5}};
    const LawFit found = fit_from(masses(1), states, law_starts(*masses(1), states, {truth.law}, nothing_beside), options);
    const LawFit from_truth = fit_laws(masses(1), states, LawUnknowns(joint_of(truth)), options);
    EXPECT_EQ(word(found.status), "converged") << truth.law;
    EXPECT_NEAR(found.chi_square, from_truth.chi_square, 1e-6 * found.chi_square) << truth.law;
  }
}

TEST(LawStart, KnowsTheSpringBeside) {
  const Joint beside = {.name = "joint", .stiffness = 60.0, .damping = 0.2};
  Joint joint = beside;
  joint.friction = law("bilinear", {0.006, 150.0});
  const auto states = measure(masses(1), {joint}, levels, omegas);
  ASSERT_FALSE(states.empty());
  const std::vector<Joint> start = law_starts(*masses(1), states, {"bilinear"}, {beside}).front();
  EXPECT_EQ(start[0].stiffness, 60.0);
  EXPECT_NEAR(start[0].stuck_stiffness(), 210.0, 10.0);
}

/// Levels that reach macroslip, noise of 1e-4 on responses of up to 0.2: AIC names the law, from data alone.
TEST(LawChoice, FindsTheTrueLaw) {
  std::mt19937_64 generator(11);
  for (const Truth& truth : truths) {
    const auto exact = measure(masses(1), joint_of(truth), levels, omegas);
    ASSERT_FALSE(exact.empty());
    const auto compared = compare_laws(masses(1), noisy(exact, generator), {{"bilinear"}, {"shoukry"}, {"ren"}, {"iwan"}},
                                       nothing_beside, {.harmonics = {1, 3, 5}});
    ASSERT_EQ(compared.size(), 4u);
    const LawCandidate& chosen = compared[chosen_law(compared)];
    EXPECT_EQ(chosen.laws[0], truth.law) << compared[0].fit.aic << " " << compared[1].fit.aic;
    EXPECT_EQ(word(chosen.fit.status), "converged") << truth.law;
    EXPECT_LT(chosen.fit.chi_square, 1.5 * static_cast<double>(chosen.fit.freedom)) << truth.law;
  }
}

/// What is tried first depends on the data, not on the order in which laws are named.
TEST(LawChoice, DoesNotDependOnTheOrderOfTheLaws) {
  std::mt19937_64 generator(3);
  const auto states = noisy(measure(masses(1), joint_of(truths[0]), levels, omegas), generator);
  const std::vector<std::vector<std::string>> laws = {{"bilinear"}, {"shoukry"}, {"ren"}, {"iwan"}};
  const auto forwards = compare_laws(masses(1), states, laws, nothing_beside, {.harmonics = {1, 3}});
  const auto backwards = compare_laws(masses(1), states, {laws.rbegin(), laws.rend()}, nothing_beside, {.harmonics = {1, 3}});
  ASSERT_EQ(forwards.size(), backwards.size());
  for (std::size_t i = 0; i < forwards.size(); ++i) {
    EXPECT_EQ(forwards[i].laws, backwards[i].laws);
    EXPECT_EQ(forwards[i].fit.chi_square, backwards[i].fit.chi_square) << forwards[i].laws[0];
  }
}

/// Levels far below slip: laws cannot be told apart, and the stiffness is known all the same.
TEST(LawChoice, CannotTellLawsThatDoNotSlip) {
  std::mt19937_64 generator(5);
  const auto exact = measure(masses(1), {{.name = "joint", .friction = law("bilinear", {0.5, 200.0})}}, {1.0}, omegas);
  const auto compared =
      compare_laws(masses(1), noisy(exact, generator), {{"spring"}, {"bilinear"}}, nothing_beside, {.harmonics = {1, 3}});
  EXPECT_EQ(compared[0].laws[0], "spring");
  EXPECT_EQ(chosen_law(compared), 0u);
  EXPECT_NEAR(compared[0].fit.joints[0].stiffness.value, 200.0, 4.0 * *compared[0].fit.joints[0].stiffness.std_error);
  EXPECT_NEAR(compared[1].fit.aic - compared[0].fit.aic, 2.0, 1.0);
}

TEST(LawChoice, RefusesLawsThatThereAreNot) {
  const auto states = measure(masses(1), joint_of(truths[0]), {1.0}, {18.0});
  EXPECT_THROW(law_starts(*masses(1), states, {"no such law"}, nothing_beside), InputError);
  EXPECT_THROW(law_starts(*masses(1), states, {"ren", "ren"}, nothing_beside), InputError);
}

}  // namespace
}  // namespace jointid::response

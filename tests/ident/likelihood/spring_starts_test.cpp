#include "ident/likelihood/fit/spring_starts.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "base/statistics.hpp"
#include "ident/identify.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"

namespace jointid::ident {
namespace {

using restrictions::Kind;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Three lines of joint coordinates alone, H_ii being `receptances` on the first, and 2.5 and 9 times as large on the others.
class JointAlone final : public LikelihoodData {
 public:
  explicit JointAlone(const std::vector<double>& receptances) {
    layout_.joint = receptances.size();
    for (std::size_t i = 0; i < receptances.size(); ++i) {
      for (std::size_t j = i; j < receptances.size(); ++j) layout_.sub_jj.push_back({i, j});
    }
    for (const double factor : {1.0, 9.0, 2.5}) {
      LineData line;
      for (const Element& e : layout_.sub_jj) {
        line.sub_jj.value.emplace_back(0.0, factor * (e.row == e.column ? receptances[e.row] : 7.0));
        line.sub_jj.weight.emplace_back(receptances[e.row] > 0.0 ? 1.0 : 0.0);
      }
      data_.push_back(line);
    }
  }

  bool variances_by_law() const override { return false; }
  void weigh_as_measured() override {}
  void weigh_at(std::size_t, const LineState&, const ComplexMatrix&) override {}
};

/// Case H4: only H_nn of the assembly, joint coordinates 4:+Y, 4:+RZ of one beam and 5:+Y, 5:+RZ of the other.
class SpringStarts : public testing::Test {
 protected:
  SpringStarts() : problem_(problems::make("H4")), scene_(problems::scene(problem_)) {
    scene_.identify.method = Method::likelihood;
    scene_.identify.start.clear();
  }

  std::unique_ptr<Plan> plan() const { return problems::plan(scene_, {problem_.substructures, problem_.assembly}); }

  /// The stiffness of a start, in the order of the unknowns: K(1,1), K(1,2), … of the upper triangle.
  static std::vector<double> stiffness(const Plan& plan, std::vector<double> start) {
    for (std::size_t c = 0; c < start.size(); ++c) start[c] *= plan.unscale(c);
    return start;
  }

  problems::Problem problem_;
  Scene scene_;
};

TEST_F(SpringStarts, AreAsStiffAsTheSubstructuresBetweenCoordinatesOfOneDirection) {
  const auto plan = this->plan();
  const auto starts = spring_starts(*plan, JointAlone({0.4, 40.0, 1.6, 10.0}));
  ASSERT_THAT(starts, SizeIs(3));
  // Medians over the lines are 2.5 times as large. K_ij = −1/√(H_ii H_jj); K_ii = 1/H_ii.
  const std::vector<double> as_stiff = stiffness(*plan, starts[0]);
  const std::vector<double> expected = {1.0, 0.0, -0.5, 0.0, 0.01, 0.0, -0.02, 0.25, 0.0, 0.04};
  for (std::size_t u = 0; u < expected.size(); ++u) EXPECT_NEAR(as_stiff[u], expected[u], 1e-14) << u;
  for (const auto& [guess, factor] : {std::pair(1, 100.0), std::pair(2, 0.01)}) {
    const std::vector<double> turned = stiffness(*plan, starts[static_cast<std::size_t>(guess)]);
    for (const std::size_t u : {0u, 2u, 7u}) EXPECT_NEAR(turned[u], expected[u], 1e-12) << u;
    for (const std::size_t u : {4u, 6u, 9u}) EXPECT_NEAR(turned[u], factor * expected[u], 1e-12) << u;
  }
}

TEST_F(SpringStarts, FollowTheSignsOfCoordinatesAndTheRestriction) {
  scene_.joints.front().dofs[2] = frf::Dof::parse("5:-Y");
  scene_.truth.clear();
  const auto turned = plan();
  const std::vector<double> k = stiffness(*turned, spring_starts(*turned, JointAlone({0.4, 0.4, 0.4, 0.4}))[0]);
  EXPECT_NEAR(k[2], 1.0, 1e-14);   // 4:+Y, 5:-Y
  EXPECT_NEAR(k[6], -1.0, 1e-14);  // 4:+RZ, 5:+RZ
  scene_.joints.front().matrices[Kind::stiffness] = restrictions::Pattern::diagonal;
  const auto diagonal = plan();
  EXPECT_THAT(stiffness(*diagonal, spring_starts(*diagonal, JointAlone({0.4, 0.4, 0.4, 0.4}))[0]),
              testing::Each(testing::DoubleNear(1.0, 1e-14)));
}

TEST_F(SpringStarts, AreNotThereWithoutStiffnessOrReceptancesOrACommonDirection) {
  EXPECT_THAT(spring_starts(*plan(), JointAlone({0.4, 0.0, 0.4, 0.4})), IsEmpty());
  scene_.truth.clear();
  Scene other = scene_;
  auto& matrices = other.joints.front().matrices;
  matrices[Kind::mass] = matrices.at(Kind::stiffness);
  matrices.erase(Kind::stiffness);
  EXPECT_THAT(
      spring_starts(*problems::plan(other, {problem_.substructures, problem_.assembly}), JointAlone({0.4, 0.4, 0.4, 0.4})),
      IsEmpty());
  other = scene_;
  other.joints.front().dofs = {frf::Dof::parse("4:+Y"), frf::Dof::parse("5:+RZ")};
  EXPECT_THAT(spring_starts(*problems::plan(other, {problem_.substructures, problem_.assembly}), JointAlone({0.4, 0.4})),
              IsEmpty());
}

/// At 5 % noise the direct solution is useless, and a wrong minimum or none was found from it.
TEST_F(SpringStarts, LeadToTheJointUnderNoise) {
  std::vector<double> truth;
  for (const problems::ExactUnknown& unknown : problem_.unknowns) truth.push_back(unknown.value);
  std::size_t within = 0;
  constexpr std::size_t seeds = 6;
  for (std::size_t seed = 1; seed <= seeds; ++seed) {
    const auto plan = problems::plan(scene_, problems::polluted(problem_, seed, 0));
    Control control;
    control.threads = 1;
    const Solution found = solve(*plan, control);
    EXPECT_EQ(found.status, Status::ok) << seed << found.message;
    for (std::size_t u = 0; u < truth.size(); ++u) {
      ASSERT_TRUE(found.unknowns[u].std_error.has_value()) << seed;
      const double deviations = std::abs(found.unknowns[u].value - truth[u]) / *found.unknowns[u].std_error;
      EXPECT_LT(deviations, 5.0) << seed << ' ' << found.unknowns[u].name;
      within += deviations < normal_95;
    }
  }
  EXPECT_GE(within, 48u);  // of 60, 57 expected
}

TEST_F(SpringStarts, WithoutNoiseTheDirectSolutionIsTheFirst) {
  const auto plan = this->plan();
  EXPECT_THAT(plan->notes, testing::Contains(HasSubstr("starts are guessed")));
  const Solution found = solve(*plan, {});
  EXPECT_EQ(found.status, Status::ok);
  for (std::size_t u = 0; u < problem_.unknowns.size(); ++u) {
    EXPECT_NEAR(found.unknowns[u].value / problem_.unknowns[u].value, 1.0, 1e-9) << found.unknowns[u].name;
  }
}

/// No start need have led to the joint, so no more is said than that none did.
TEST_F(SpringStarts, WhatFitsNowhereIsNotSaidOfTheScene) {
  for (Complex& value : problem_.assembly.values) value *= 3.0;
  scene_.frequency.step_hz = 50.0;
  const auto plan = this->plan();
  const Solution found = solve(*plan, {});
  EXPECT_FALSE(is_usable(found.status));
  EXPECT_THAT(found.message, HasSubstr("one of the joints that starts led to explains the FRFs"));
  EXPECT_THAT(found.message, HasSubstr("starts = 40"));
}

}  // namespace
}  // namespace jointid::ident

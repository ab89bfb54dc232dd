#include "tasks/bound_report.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "base/error.hpp"
#include "tests/ident/likelihood_case.hpp"
#include "memory_systems.hpp"
#include "tasks/bound.hpp"

namespace jointid::ident {
namespace {

using ::testing::HasSubstr;

/// Leaves coordinates out of all sets of a case.
problems::Measurement without(const problems::Problem& problem, const Dofs& gone) {
  const auto part = [&](const frf::FrfSet& set) {
    Dofs kept;
    for (const frf::Dof& dof : set.header.response) {
      if (frf::find_coordinate(gone, dof) == frf::npos) kept.push_back(dof);
    }
    return part_of(set, kept, kept);
  };
  problems::Measurement out{{}, part(problem.assembly)};
  for (const frf::FrfSet& set : problem.substructures) out.substructures.push_back(part(set));
  return out;
}

std::vector<double> truth_of(const problems::Problem& problem) {
  std::vector<double> values;
  for (const problems::ExactUnknown& unknown : problem.unknowns) values.push_back(unknown.value);
  return values;
}

TEST(BoundReport, IsTheBoundAtTheTruth) {
  const LikelihoodCase a1("A1", 0.01);
  const tasks::BoundReport report = tasks::predict_bound(*a1.clean(), {}, {});
  const std::vector<double> bound = tasks::cramer_rao_bound(*a1.clean(), truth_of(a1.problem), {});
  ASSERT_EQ(report.unknowns.size(), bound.size());
  for (std::size_t i = 0; i < bound.size(); ++i) EXPECT_NEAR(report.unknowns[i].bound, bound[i], 1e-6 * bound[i]);
  EXPECT_EQ(report.without_lines.size(), 10u);
  EXPECT_FALSE(report.weakest.empty());
}

TEST(BoundReport, LeavingACoordinateOutIsNotHavingMeasuredIt) {
  const LikelihoodCase a1("A1", 0.01);
  const tasks::BoundReport report = tasks::predict_bound(*a1.clean(), {}, {});
  const frf::Dof gone = frf::Dof::parse(report.without_coordinate.front().what);
  const auto smaller = problems::plan(a1.scene, without(a1.problem, {gone}));
  const std::vector<double> bound = tasks::cramer_rao_bound(*smaller, truth_of(a1.problem), {});
  for (std::size_t i = 0; i < bound.size(); ++i) {
    const double expected = bound[i] / report.unknowns[i].bound;
    EXPECT_NEAR(report.without_coordinate.front().factors[i], expected, 1e-4 * expected) << i;
    EXPECT_GE(expected, 1.0 - 1e-6);
  }
}

TEST(BoundReport, ACandidateBringsBackWhatLeavingItOutCosts) {
  const LikelihoodCase a1("A1", 0.01);
  const tasks::BoundReport all = tasks::predict_bound(*a1.clean(), {}, {});
  const std::string name = all.without_coordinate.front().what;
  const tasks::BoundReport fewer = tasks::predict_bound(*a1.clean(), {frf::Dof::parse(name)}, {});
  ASSERT_FALSE(fewer.with_more.empty());
  EXPECT_EQ(fewer.with_more.front().what, name);
  for (std::size_t i = 0; i < all.unknowns.size(); ++i) {
    EXPECT_NEAR(fewer.with_more.front().factors[i] * all.without_coordinate.front().factors[i], 1.0, 1e-6);
  }
}

TEST(BoundReport, LinesThatTheSceneLeavesOutAreOffered) {
  LikelihoodCase a1("A1", 0.01);
  a1.scene.identify.method = Method::one;
  a1.scene.frequency.range_hz = Range{400.0, 700.0};
  const tasks::BoundReport report = tasks::predict_bound(*a1.clean(), {}, {});
  ASSERT_FALSE(report.with_more.empty());
  EXPECT_THAT(report.with_more.front().what, HasSubstr("all 31 lines of the files, 400 to 1000 Hz"));
  EXPECT_LT(report.with_more.front().worst, 1.0);
  for (const double factor : report.with_more.front().factors) EXPECT_LE(factor, 1.0 + 1e-9);
}

/// Exact FRFs there and back agree. Where both are to be measured, each with noise of its own, the bound is that of both; it was
/// that of one, a third above what noisy data state.
TEST(BoundReport, CountsBothFrfsOfAReciprocalPairWhereTheirNoiseIsApart) {
  LikelihoodCase a1("A1", 0.01);
  std::get<frf::NoiseModel>(a1.problem.noise).reciprocal = false;
  a1.scene.noise->frf_model.reciprocal = false;
  const tasks::BoundReport report = tasks::predict_bound(*a1.clean(), {}, {});
  Control control;
  control.threads = 1;
  control.judgement = Judgement::fit;
  constexpr std::uint64_t seeds = 4;
  double ratio = 0.0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const Solution found = solve(*a1.polluted(seed), control);
    for (std::size_t u = 0; u < found.unknowns.size(); ++u)
      ratio += report.unknowns[u].bound / *found.unknowns[u].std_error / static_cast<double>(seeds * found.unknowns.size());
  }
  EXPECT_NEAR(ratio, 1.0, 0.05);
  a1.scene.noise->frf_model.reciprocal = true;
  EXPECT_GT(tasks::predict_bound(*a1.clean(), {}, {}).unknowns.front().bound, 1.05 * report.unknowns.front().bound);
}

TEST(BoundReport, NeedsAJointToAssume) {
  LikelihoodCase a1("A1");
  const Matrix stiffness = a1.scene.truth.begin()->second;
  a1.scene.truth.clear();
  try {
    tasks::predict_bound(*a1.clean(), {}, {});
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("neither [truth] nor [identify] start"));
  }
  a1.scene.identify.start[restrictions::Kind::stiffness] = stiffness;
  EXPECT_EQ(tasks::predict_bound(*a1.clean(), {}, {}).unknowns.size(), a1.problem.unknowns.size());
}

TEST(BoundReport, ACandidateThatNoFileHasIsAnErrorWithTheNearest) {
  try {
    tasks::predict_bound(*LikelihoodCase("A1").clean(), {frf::Dof::parse("1:+Z")}, {});
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean 1:+Y?"));
  }
}

}  // namespace
}  // namespace jointid::ident

#include "tests/ident/likelihood_accuracy.hpp"

#include <gtest/gtest.h>

#include "ident/identify.hpp"

namespace jointid::ident {
namespace {

/// Prints what was found, for the log of a test that fails.
std::string text(const Accuracy& a) {
  return "mean " + std::to_string(a.mean) + ", worst " + std::to_string(a.worst) + ", coverage " + std::to_string(a.coverage()) +
         ", not converged " + std::to_string(a.failed);
}

TEST(LikelihoodAccuracy, ReachesTheBoundAtFivePerCent) {
  constexpr std::size_t trials = 40;
  LikelihoodCase a1("A1");
  const std::vector<double> bound = a1.at(0.05).bound();
  const Accuracy found = accuracy_of(a1, bound, trials);
  RecordProperty("found", text(found));
  EXPECT_LE(found.mean, 1.1) << text(found);
  EXPECT_LE(found.worst, 1.4) << text(found);
  EXPECT_GE(found.coverage(), found.least_coverage(trials)) << text(found);
  EXPECT_EQ(found.failed, 0u);
}

TEST(LikelihoodAccuracy, TinyNoiseGivesTheTruth) {
  LikelihoodCase a1("A1");
  const std::vector<double> bound = a1.at(1e-6).bound();
  const auto trials = study::run_trials(problems::trial_data(a1.scene, a1.problem), {.trials = 1});
  ASSERT_EQ(trials[0].status, Status::ok);
  for (std::size_t u = 0; u < a1.truth.size(); ++u) {
    EXPECT_NEAR(trials[0].values[u], a1.truth[u], 5.0 * bound[u]) << a1.problem.unknowns[u].name;
    EXPECT_LT(bound[u], 1e-3 * std::max(std::abs(a1.truth[u]), 1.0)) << a1.problem.unknowns[u].name;
  }
}

/// Some lines with errors ten times as large as the variances say, against the bound of the data without those lines.
TEST(LikelihoodAccuracy, LinesWithGrossErrorsCostLittle) {
  LikelihoodCase a1("A1");
  const std::vector<double> bound = a1.at(0.01).bound();
  std::get<frf::NoiseModel>(a1.problem.noise).gross = {.share = 0.05, .factor = 10.0};
  const Accuracy found = accuracy_of(a1, bound, 20);
  RecordProperty("found", text(found));
  const double fewer_lines = std::sqrt(1.0 / std::pow(0.95, 3.0));  // three sets, each with bad lines of its own
  EXPECT_LE(found.mean / fewer_lines, 1.2) << text(found);
}

/// Five hits per FRF: single coherences make weights that scatter, which costs coverage; smoothed ones do not.
TEST(LikelihoodAccuracy, CoherencesOfAHammerTestGiveHonestIntervals) {
  LikelihoodCase rig("rig1");
  rig.scene.frequency.step_hz = 16.0;
  const std::vector<double> newton_per_metre(rig.truth.size(), 1.0);
  rig.scene.identify.smooth_variance = false;
  const Accuracy single = accuracy_of(rig, newton_per_metre, 12);
  rig.scene.identify.smooth_variance = true;
  const Accuracy smooth = accuracy_of(rig, newton_per_metre, 12);
  RecordProperty("single", text(single));
  RecordProperty("smooth", text(smooth));
  EXPECT_GE(single.coverage(), 0.8) << text(single);
  EXPECT_GE(smooth.coverage(), 0.9) << text(smooth);
  EXPECT_LT(smooth.mean, single.mean) << text(smooth);
  EXPECT_EQ(single.failed + smooth.failed, 0u);
}

TEST(LikelihoodAccuracy, ThreadsDoNotChangeABit) {
  LikelihoodCase a1("A1");
  a1.at(0.05);
  const auto noisy = problems::polluted(a1.problem, 3, 0);
  std::vector<std::vector<double>> values;
  for (const std::size_t threads : {1u, 2u, 3u}) {
    Control control;
    control.threads = threads;
    const Solution solution = solve(*problems::plan(a1.scene, noisy), control);
    std::vector<double>& own = values.emplace_back();
    for (const Estimate& estimate : solution.unknowns) own.insert(own.end(), {estimate.value, *estimate.std_error});
    own.push_back(solution.fit.chi_square->value);
  }
  EXPECT_EQ(values[0], values[1]);
  EXPECT_EQ(values[0], values[2]);
}

}  // namespace
}  // namespace jointid::ident

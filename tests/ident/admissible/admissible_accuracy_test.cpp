#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

#include "ident/identify.hpp"
#include "ident/scene/read_scene.hpp"
#include "joint_eigenvalues.hpp"
#include "problems/problem.hpp"
#include "tests/ident/likelihood_accuracy.hpp"
#include "tests/test_folder.hpp"

namespace jointid::ident {
namespace {

using restrictions::Kind;

struct Setting {
  const char* problem;
  Method method;
  std::size_t seeds;
};

/// rms over the trials of the rms relative error of a matrix, over those that both runs settled in.
double rms_error(const std::vector<study::Trial>& trials, const std::vector<study::Trial>& others, std::size_t matrix) {
  double squares = 0.0, count = 0.0;
  for (std::size_t t = 0; t < trials.size(); ++t) {
    if (trials[t].status != Status::ok || others[t].status != Status::ok) continue;
    squares += std::pow(trials[t].quality[matrix].rms_relative_error, 2.0);
    ++count;
  }
  return std::sqrt(squares / count);
}

double coverage(const std::vector<study::Trial>& trials, const std::vector<double>& truth) {
  double inside = 0.0, count = 0.0;
  for (const study::Trial& trial : trials) {
    for (std::size_t u = 0; u < truth.size(); ++u) {
      if (trial.status != Status::ok || !trial.ci95[u]) continue;
      inside += (*trial.ci95[u])[0] <= truth[u] && truth[u] <= (*trial.ci95[u])[1];
      ++count;
    }
  }
  return inside / count;
}

std::size_t settled(const std::vector<study::Trial>& trials) {
  return static_cast<std::size_t>(std::ranges::count(trials, Status::ok, &study::Trial::status));
}

class AdmissibleAccuracy : public ::testing::TestWithParam<Setting> {};

TEST_P(AdmissibleAccuracy, ConstraintsDoNotMakeErrorsLarger) {
  const Setting way = GetParam();
  const std::size_t seeds = way.seeds;
  LikelihoodCase run(way.problem);
  run.at(0.05);
  run.scene.identify.method = way.method;
  run.scene.identify.weighting = weighting::Weighting::wb;
  const auto data = problems::trial_data(run.scene, run.problem);
  const std::vector<study::Trial> free = study::run_trials(data, {.trials = seeds});
  for (const auto& [kind, matrix] : run.scene.joints[0].matrices) run.scene.joints[0].definite.insert(kind);
  const auto constrained_data = problems::trial_data(run.scene, run.problem);
  const std::vector<study::Trial> constrained = study::run_trials(constrained_data, {.trials = seeds});
  std::size_t indefinite = 0;
  const auto plan = problems::plan(run.scene, problems::polluted(run.problem, 1, 0));
  for (std::size_t t = 0; t < seeds; ++t) {
    double before = 1.0;
    for (const Kind kind : data->judged) {
      before = std::min(before, least_relative_eigenvalue(plan->restriction.matrix(kind, free[t].values)));
      if (constrained[t].status != Status::ok) continue;
      EXPECT_GE(least_relative_eigenvalue(plan->restriction.matrix(kind, constrained[t].values)), -1e-10) << t;
    }
    indefinite += before < -1e-10;
  }
  EXPECT_GT(2 * indefinite, seeds);  // else nothing was constrained
  for (std::size_t k = 0; k < data->judged.size(); ++k) {
    const double before = rms_error(free, constrained, k), after = rms_error(constrained, free, k);
    EXPECT_LT(after, before) << restrictions::key(data->judged[k]);
  }
  EXPECT_GE(settled(constrained), settled(free) - 1 - seeds / 50);
  if (way.method != Method::likelihood) return;
  EXPECT_GE(coverage(constrained, run.truth), coverage(free, run.truth) - 0.01);
}

// 200 seeds of each, and their figures: bench_admissible.
INSTANTIATE_TEST_SUITE_P(Cases, AdmissibleAccuracy,
                         ::testing::Values(Setting{"A1", Method::one, 100}, Setting{"C1", Method::one, 100},
                                           Setting{"D1", Method::one, 100}, Setting{"A1", Method::likelihood, 12},
                                           Setting{"C1", Method::likelihood, 12}, Setting{"D1", Method::likelihood, 8}));

/// As case B5 of Table 7.4: joint B from FRFs regenerated from modal data, without the ends of the range.
TEST(AdmissibleRegenerated, CaseB5TellsTheConstraintAndItsCost) {
  const TestFolder folder;
  Scene scene = read_scene(problems::write(problems::make("rig1"), folder, {}));
  scene.data.regenerate = {.substructures = true, .assembly = true};
  scene.frequency.range_hz = Range{116.0, 1676.0};
  const Solution free = solve(*make_plan(scene));
  scene.joints[0].definite = {Kind::stiffness, Kind::hysteretic_damping};
  const Solution found = solve(*make_plan(scene));
  ASSERT_EQ(found.status, Status::ok);
  std::printf("least over largest eigenvalue %.3g without, %.3g with; cost %.4g by %zu equations\n",
              least_relative_eigenvalue(free), least_relative_eigenvalue(found), found.admissibility->chi_square,
              found.admissibility->equations);
  for (const ConstraintOutcome& each : found.admissibility->constraints) {
    std::printf("  %s: %zu of %zu at the limit, cost %.4g\n", each.text.c_str(), each.at_limit, each.size, each.chi_square);
  }
  for (const auto& [kind, figures] : found.quality) {
    std::printf("  %s: rms relative error %.4g without, %.4g with\n", restrictions::symbol(kind).c_str(),
                free.quality.at(kind).rms_relative_error, figures.rms_relative_error);
  }
  EXPECT_GE(least_relative_eigenvalue(found), -1e-10);
  EXPECT_NEAR(found.quality.at(Kind::stiffness).rms_relative_error, 0.0265, 0.0005);  // docs/admissible-joints.md
  EXPECT_NEAR(found.quality.at(Kind::hysteretic_damping).rms_relative_error, 0.678, 0.005);
  EXPECT_NEAR(least_relative_eigenvalue(found), 0.0076, 0.0003);
  EXPECT_GE(found.admissibility->chi_square, 0.0);
  EXPECT_EQ(found.admissibility->equations > 0, least_relative_eigenvalue(free) < 0.0);
}

}  // namespace
}  // namespace jointid::ident

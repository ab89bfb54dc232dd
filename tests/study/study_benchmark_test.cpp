// An independent program's results for cases A1 and B, over 400 trials of ours.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "study/study.hpp"
#include "study/study_statistics.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"
#include "tests/test_folder.hpp"

namespace jointid::study {
namespace {

struct Settings {
  std::vector<ident::Equation> equations;
  weighting::Weighting weighting;
  double delta = 0.0;
};

StudyStatistics study(const char* problem_name, const Settings& settings) {
  const problems::Problem problem = problems::make(problem_name);
  ident::Scene scene = problems::scene(problem);
  scene.identify.equations = settings.equations;
  scene.identify.weighting = settings.weighting;
  scene.identify.delta = settings.delta;
  StudyOptions options;
  options.trials = 400;
  const TestFolder folder;
  options.out = folder / "study.h5";
  const auto team = ident::make_team_of_one();
  run_study(problems::trial_data(scene, problem), options, *team);
  return study_statistics(options.out);
}

const QualityStatistics& of(const StudyStatistics& statistics, const std::string& matrix) {
  for (const QualityStatistics& quality : statistics.quality) {
    if (quality.matrix == matrix) return quality;
  }
  throw std::out_of_range(matrix);
}

struct A1Error {
  weighting::Weighting weighting;
  double k, k_rounding, d, d_rounding;  ///< printed rms error and half a unit of its last digit
};

class BenchmarkA1 : public testing::TestWithParam<A1Error> {};

TEST_P(BenchmarkA1, RmsErrorsAgreeWithin10PercentBesideTheirRounding) {
  const A1Error& print = GetParam();
  const StudyStatistics s = study("A1", {{ident::Equation::nn, ident::Equation::nj}, print.weighting});
  EXPECT_EQ(s.usable, 400u);
  EXPECT_NEAR(of(s, "stiffness").rms_over_trials, print.k, 0.1 * print.k + print.k_rounding);
  EXPECT_NEAR(of(s, "hysteretic_damping").rms_over_trials, print.d, 0.1 * print.d + print.d_rounding);
}

using enum weighting::Weighting;
INSTANTIATE_TEST_SUITE_P(Weightings, BenchmarkA1,
                         testing::Values(A1Error{none, 0.79, 0.005, 40.0, 0.5}, A1Error{wa, 0.09, 0.005, 1.6, 0.05},
                                         A1Error{wb, 0.09, 0.005, 1.3, 0.05}, A1Error{wbg, 0.4, 0.05, 8.0, 0.5},
                                         A1Error{wbs, 0.5, 0.05, 38.0, 0.5}));

struct BFigures {
  Settings settings;
  const char* matrix;
  double rjcf, arvf;  ///< medians over 12 seeds; arvf 0: not printed
};

class BenchmarkB : public testing::TestWithParam<BFigures> {};

/// 0.03, and twice the standard error of a median of 12 as the spread of ours gives it (1.2533·σ/√12, σ = quartile range/1.349).
double tolerance(const Quantiles& q) { return 0.03 + 2.0 * 1.2533 * (q[3] - q[1]) / 1.349 / std::sqrt(12.0); }

TEST_P(BenchmarkB, MediansAgreeWithThoseOf12Seeds) {
  const BFigures& print = GetParam();
  const QualityStatistics quality = of(study("B", print.settings), print.matrix);
  EXPECT_NEAR(quality.rjcf[2], print.rjcf, tolerance(quality.rjcf));
  if (print.arvf > 0.0) {
    EXPECT_NEAR(quality.arvf[2], print.arvf, tolerance(quality.arvf));
  }
}

const std::vector<ident::Equation> nn = {ident::Equation::nn};
const std::vector<ident::Equation> all = {ident::Equation::nn, ident::Equation::nj, ident::Equation::jj, ident::Equation::jn};
INSTANTIATE_TEST_SUITE_P(
    Settings, BenchmarkB,
    testing::Values(BFigures{{nn, wa}, "stiffness", 0.67, 0.38}, BFigures{{nn, wb}, "stiffness", 0.65, 0.39},
                    BFigures{{nn, wbg}, "stiffness", 0.95, 0.91}, BFigures{{nn, wbs}, "stiffness", 0.53, 0.85},
                    BFigures{{nn, wbs, 0.1}, "stiffness", 0.99, 0.94}, BFigures{{all, wbs}, "hysteretic_damping", 0.50, 0.0},
                    BFigures{{all, wbs, 0.2}, "hysteretic_damping", 0.91, 0.0}, BFigures{{all, wa}, "stiffness", 0.999, 0.0},
                    BFigures{{all, wbs}, "stiffness", 0.999, 0.0}));

}  // namespace
}  // namespace jointid::study

// Errors that variances do not tell: a common gain, what FRFs of one hit share, misfit; and the intervals with them.
#include <gmock/gmock.h>

#include <cmath>
#include <functional>

#include "base/random.hpp"
#include "ident/likelihood/errors/block_jackknife.hpp"
#include "ident/likelihood/errors/chi_square_law.hpp"
#include "tests/ident/likelihood_case.hpp"

namespace jointid::ident {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using problems::Measurement;

Control control_of(Detail detail = Detail::estimates) {
  Control control;
  control.threads = 1;
  control.detail = detail;
  control.judgement = Judgement::fit;
  return control;
}

Solution solution_of(const Scene& scene, const Measurement& data, Detail detail = Detail::full) {
  return solve(*problems::plan(scene, data), control_of(detail));
}

Scene calibrated(Scene scene) {
  scene.data.gains = {GainPrior{}};
  return scene;
}

void expect_all_within(const Solution& found, const problems::Problem& problem, double errors) {
  for (std::size_t u = 0; u < found.unknowns.size(); ++u) {
    const double truth = problem.unknowns[u].value;
    if (truth == 0.0) continue;
    EXPECT_LT(std::abs(found.unknowns[u].value - truth), errors * *found.unknowns[u].std_error) << found.unknowns[u].name;
  }
}

double share_inside(const Solution& found, const problems::Problem& problem) {
  double inside = 0.0, count = 0.0;
  for (std::size_t u = 0; u < found.unknowns.size(); ++u) {
    const double truth = problem.unknowns[u].value;
    if (truth == 0.0) continue;
    ++count;
    const auto& interval = found.unknowns[u].ci95;
    inside += interval && (*interval)[0] <= truth && truth <= (*interval)[1] ? 1.0 : 0.0;
  }
  return inside / count;
}

TEST(UnstatedErrors, OfCleanDataMoveNoEstimateAndCostLittle) {
  const LikelihoodCase a1("A1", 0.01);
  const Measurement data = problems::polluted(a1.problem, 1, 0);
  const Solution found = solution_of(a1.scene, data), exact = solution_of(calibrated(a1.scene), data);
  EXPECT_EQ(found.status, Status::ok) << found.message;
  EXPECT_THAT(found.systematic, IsEmpty());
  for (std::size_t u = 0; u < found.unknowns.size(); ++u) {
    const Estimate &one = found.unknowns[u], &other = exact.unknowns[u];
    EXPECT_EQ(one.value, other.value);
    EXPECT_EQ(*one.std_error, *other.std_error);
    EXPECT_LT((*one.ci95)[1] - (*one.ci95)[0], 1.15 * ((*other.ci95)[1] - (*other.ci95)[0]));
    EXPECT_NEAR((*other.ci95)[1] - other.value, 1.959963984540054 * *other.std_error, 1e-9 * *other.std_error);
  }
  EXPECT_THAT(found.variances.back().note, HasSubstr("1 ± 0.01"));
  EXPECT_THAT(exact.variances.back().note, IsEmpty());
}

TEST(UnstatedErrors, ACommonGainIsFoundAndTakenOff) {
  const LikelihoodCase a1("A1", 0.01);
  Measurement data = problems::polluted(a1.problem, 2, 0);
  for (Complex& value : data.assembly.values) value *= 1.01;
  const auto plan = problems::plan(a1.scene, data);
  const Solution found = solve(*plan, control_of(Detail::full)), again = solve(*plan, control_of(Detail::full));
  EXPECT_EQ(found.status, Status::doubtful);
  EXPECT_THAT(found.message, HasSubstr("common gain of 0.99"));
  ASSERT_EQ(found.systematic.size(), 1U);
  EXPECT_NEAR(found.systematic[0].value, 1.0 / 1.01, 4.0 * *found.systematic[0].std_error);
  EXPECT_LT(*found.systematic[0].std_error, 1e-3);
  expect_all_within(found, a1.problem, 4.0);
  for (std::size_t u = 0; u < found.unknowns.size(); ++u) EXPECT_EQ(found.unknowns[u].value, again.unknowns[u].value);
  const Solution exact = solution_of(calibrated(a1.scene), data);
  EXPECT_THAT(exact.systematic, IsEmpty());
  EXPECT_NE(exact.status, Status::ok);
}

/// H1 of five hits whose force has noise of 14 % of it, and coherences.
frf::FrfSet hit(const frf::FrfSet& exact, std::uint64_t set) {
  constexpr std::size_t hits = 5;
  constexpr double force_noise = 0.14, floor = 1e-3;
  frf::FrfSet out = exact;
  out.variance.clear();
  out.header.noise = frf::NoiseRecord::coherence;
  out.header.averages = hits;
  out.coherence.resize(out.values.size());
  const std::size_t references = exact.header.reference.size();
  for (std::size_t i = 0; i < exact.values.size(); ++i) {
    const std::size_t line = i / exact.header.entries(), channel = line * references + i % references;
    Complex cross = 0.0;
    double force = 0.0, motion = 0.0;
    for (std::uint64_t h = 0; h < hits; ++h) {
      const auto f = normal_numbers({5, h, set}, channel), x = normal_numbers({6, h, set}, i);
      const Complex signal = 1.0 + force_noise * Complex(f[0], f[1]) / std::sqrt(2.0);
      const Complex response = exact.values[i] * (1.0 + floor * Complex(x[0], x[1]));
      cross += std::conj(signal) * response;
      force += std::norm(signal);
      motion += std::norm(response);
    }
    out.values[i] = cross / force;
    out.coherence[i] = std::norm(cross) / (force * motion);
  }
  return out;
}

TEST(UnstatedErrors, NoiseOfTheForceIsNamedAndIntervalsReachOverItsBias) {
  LikelihoodCase rig("rig1");
  rig.scene.noise.reset();
  rig.scene.frequency.step_hz = 16.0;
  const problems::Problem& of = rig.problem;
  const Solution found = solution_of(rig.scene, {{hit(of.substructures[0], 0), hit(of.substructures[1], 1)}, hit(of.assembly, 2)});
  EXPECT_EQ(found.status, Status::doubtful) << found.message;
  EXPECT_THAT(found.message, HasSubstr("Noise of the force's signal"));
  EXPECT_THAT(found.variances.front().note, HasSubstr("alike"));
  EXPECT_GE(share_inside(found, of), 0.8);
}

TEST(UnstatedErrors, CoherencesWithoutSharedErrorsAreNotedOnce) {
  LikelihoodCase rig("rig1");
  rig.scene.noise.reset();
  rig.scene.frequency.step_hz = 16.0;
  const Solution found = solution_of(rig.scene, problems::polluted(rig.problem, 1, 0));
  EXPECT_EQ(found.status, Status::ok) << found.message;
  EXPECT_THAT(found.variances[0].note, HasSubstr("assumed independent"));
  EXPECT_THAT(found.variances[1].note, IsEmpty());
}

/// Scores of one unknown from lines with errors of their own: information 1, gradient the error less the mean of all.
Jackknife jackknife_of(const std::function<double(std::size_t)>& error) {
  constexpr std::size_t lines = 400;
  double mean = 0.0;
  for (std::size_t i = 0; i < lines; ++i) mean += error(i) / lines;
  BlockScores blocks(lines, 1);
  Scores whole = Scores::none(1);
  ReducedLine reduced{.information = Eigen::MatrixXd::Ones(1, 1), .gradient = Eigen::VectorXd::Zero(1), .back = nullptr, .own = {}};
  const std::vector<std::size_t> columns = {0};
  const LineData data;
  for (std::size_t i = 0; i < lines; ++i) {
    reduced.gradient[0] = error(i) - mean;
    const ScoredLine line{i, 1.0, columns, reduced, data};
    blocks.add(line);
    whole.add(line);
  }
  return blocks.jackknife(whole, Eigen::VectorXd()).value();
}

/// Of rig one with sensors and hits off their places, drawn for each file.
Measurement off_their_places(const LikelihoodCase& of, double metres, std::uint64_t seed) {
  problems::Problem problem = of.problem;
  std::get<frf::NoiseModel>(problem.noise).position_errors = metres;
  return problems::polluted(problem, seed, 0);
}

TEST(SensorScatter, KeepsIntervalsWhereSensorsAreFarOffTheirPlaces) {
  LikelihoodCase rig("rig1", 0.01);
  rig.scene.frequency.step_hz = 24.0;
  double share = 0.0;
  for (const std::uint64_t seed : {1U, 2U}) {
    const Solution found = solution_of(rig.scene, off_their_places(rig, 0.003, seed));
    EXPECT_EQ(found.status, Status::poor_fit);
    EXPECT_THAT(found.message, HasSubstr("by leaving out blocks of lines and sensors"));
    share += 0.5 * share_inside(found, rig.problem);
  }
  EXPECT_GE(share, 0.5);
}

TEST(SensorScatter, OfNoiseThatIsTwiceAsLargeAsToldIsAboutTwice) {
  LikelihoodCase a1("A1", 0.01);
  const Measurement data = problems::polluted(a1.problem, 3, 0);
  const Solution right = solution_of(calibrated(a1.scene), data);
  a1.scene.noise->level = a1.scene.noise->frf_model.level = 0.005;
  const Solution found = solution_of(calibrated(a1.scene), data);
  EXPECT_THAT(found.message, HasSubstr("by leaving out blocks of lines and sensors"));
  double widths = 0.0, count = 0.0;
  for (std::size_t u = 0; u < found.unknowns.size(); ++u) {
    if (!found.unknowns[u].ci95 || !right.unknowns[u].ci95) continue;
    const auto [low, high] = *found.unknowns[u].ci95;
    const auto [right_low, right_high] = *right.unknowns[u].ci95;
    widths += (high - low) / (right_high - right_low), ++count;
  }
  ASSERT_GT(count, 0.0);
  EXPECT_GT(widths / count, 0.9);
  EXPECT_LT(widths / count, 3.0);
}

TEST(BlockJackknife, OfIndependentErrorsTellsTheVarianceOfTheMean) {
  double variance = 0.0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const Jackknife of = jackknife_of([&](std::size_t i) { return normal_numbers({seed, 0, 0}, i)[0]; });
    EXPECT_FALSE(of.tells_more());
    variance += 400.0 * of.variance[0] / 100.0;
  }
  EXPECT_NEAR(variance, 1.0, 0.1);  // 1/√(100·19/2) is 0.03
}

TEST(BlockJackknife, OfErrorsThatNeighboursShareTellsMore) {
  const Jackknife of = jackknife_of([](std::size_t i) { return normal_numbers({3, 0, 0}, i / 20)[0]; });
  EXPECT_TRUE(of.tells_more());
  EXPECT_GT(400.0 * of.variance[0], 8.0);  // 20 times as many for the truth
}

TEST(ChiSquareLaw, OfKnownVariancesIsTheOneOfChiSquare) {
  const LikelihoodCase a1("A1", 0.01);
  EXPECT_NEAR(likely_chi_square(*a1.clean(), 20000.0, {}), 1.0 + 5.0 * std::sqrt(2.0 / 20000.0), 2e-3);
}

TEST(ChiSquareLaw, OfAveragesIsWiderAndKnowsReciprocity) {
  LikelihoodCase rig("rig1");
  rig.scene.noise.reset();
  const auto plan = problems::plan(rig.scene, problems::polluted(rig.problem, 1, 0));
  EXPECT_NEAR(likely_chi_square(*plan, 1e6, {.squares = 1000.0, .count = 1000.0}), 1.02, 0.01);
  EXPECT_NEAR(likely_chi_square(*plan, 1e6, {.squares = 1150.0, .count = 1000.0}), 1.15 * 1.02, 0.01);
  EXPECT_LT(likely_chi_square(*plan, 1e6, {.squares = 9000.0, .count = 1000.0}), 1.4);
  EXPECT_NEAR(likely_chi_square(*plan, 1e6, {}), 1.2 * 1.02, 0.01);
}

}  // namespace
}  // namespace jointid::ident

// What makes intervals hold: variances of errors that responses to a hit share, slopes of FRFs for stretched frequencies, and the quantile
// of an estimate with a bias of unknown size.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "base/random.hpp"
#include "base/statistics.hpp"
#include "ident/likelihood/data/frf_slopes.hpp"
#include "ident/likelihood/errors/intervals.hpp"
#include "ident/likelihood/errors/shared_variances.hpp"
#include "tests/ident/likelihood_case.hpp"
#include "problems/case/catalogue.hpp"

namespace jointid::ident {
namespace {

/// Scores g = I e + √I z of two errors a line whose information I runs over eight decades, e of the variance given.
SharedVariances scores_of(double variance, std::uint64_t seed) {
  constexpr std::size_t lines = 100;
  SharedVariances out(lines, {0, 1}, 2);
  for (std::size_t i = 0; i < lines; ++i) {
    Eigen::VectorXd gradient(2);
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(2, 2);
    for (Eigen::Index k = 0; k < 2; ++k) {
      const auto z = normal_numbers({seed, static_cast<std::uint64_t>(k), 0}, i);
      information(k, k) = std::pow(10.0, static_cast<double>(i % 9));
      gradient[k] = information(k, k) * std::sqrt(variance) * z[0] + std::sqrt(information(k, k)) * z[1];
    }
    out.add(i, gradient, information);
  }
  return out;
}

TEST(SharedVariances, AreFoundAlthoughFewScoresTellOfMost) {
  constexpr double truth = 1e-4;
  const Eigen::VectorXd most = Eigen::Vector2d::Constant(1.0);
  double mean = 0.0, square = 0.0, told = 0.0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const SharedVariances scores = scores_of(truth, seed);
    const SharedVariances::Found found = scores.estimate(most);
    EXPECT_GT(scores.significance(Eigen::Vector2d::Constant(truth)).minCoeff(), 5.0);
    for (Eigen::Index k = 0; k < 2; ++k) {
      mean += found.variance[k] / 40.0;
      square += std::pow(found.variance[k] - truth, 2) / 40.0;
      told += found.covariance(k, k) / 40.0;
    }
  }
  EXPECT_NEAR(mean, truth, 0.1 * truth);
  EXPECT_LT(std::sqrt(square), 0.3 * truth);  // √(2/45) of some 45 scores that tell; one alone would be √2
  EXPECT_NEAR(std::sqrt(told / square), 1.0, 0.3);
}

TEST(SharedVariances, OfIndependentErrorsAreNotSeen) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    EXPECT_LT(scores_of(0.0, seed).significance(Eigen::Vector2d::Constant(1e-4)).minCoeff(), 5.0);
  }
}

/// Two modes of five coordinates, lines ten times as far apart as resonances are wide.
Complex frf_of(std::size_t r, std::size_t s, double f) {
  const auto shape = [](std::size_t mode, std::size_t at) { return std::cos(static_cast<double>((mode + 1) * at) + 0.3); };
  Complex sum = 1e-5;
  for (std::size_t mode = 0; mode < 2; ++mode) {
    const double natural = mode == 0 ? 103.0 : 131.0;
    sum += shape(mode, r) * shape(mode, s) / Complex(natural * natural - f * f, 0.01 * natural * natural);
  }
  return sum;
}

TEST(FrfSlopes, HoldWhereLinesAreFartherApartThanResonancesAreWide) {
  constexpr std::size_t coordinates = 5;
  std::vector<double> frequency;
  std::vector<MeasuredFrfs> lines;
  for (std::size_t k = 0; k < FrfSlopes::most_lines; ++k) {
    frequency.push_back(90.0 + 12.0 * static_cast<double>(k));
    lines.emplace_back(coordinates);
    for (std::size_t r = 0; r < coordinates; ++r) {
      for (std::size_t s = 0; s <= r; ++s) lines.back().at(r, s) = Measured{frf_of(r, s, frequency.back()), {1e-18, 1e-18}};
    }
  }
  std::vector<const MeasuredFrfs*> all;
  for (const auto& line : lines) all.push_back(&line);
  for (std::size_t own = 0; own < lines.size(); ++own) {
    const FrfSlopes slopes({0, 1, 2, 3, 4}, frequency, all, own);
    for (std::size_t r = 0; r < coordinates; ++r) {
      const double h = 1e-3, f = frequency[own];
      const Complex exact = (frf_of(r, 0, f + h) - frf_of(r, 0, f - h)) / (2.0 * h);
      EXPECT_LT(std::abs(slopes.of({r, 0}) - exact), 0.05 * std::abs(exact)) << own << " " << r;
    }
    const Complex before = slopes.of({4, 2}), value = lines[own].at(4, 2).value;
    lines[own].at(4, 2) = Measured{1.01 * value, {1e-18, 1e-18}};
    EXPECT_LT(std::abs(slopes.of({4, 2}) - before - 0.01 * slopes.of_own_value() * value), 1e-9 * std::abs(before)) << own;
    lines[own].at(4, 2) = Measured{value, {1e-18, 1e-18}};
  }
}

TEST(FrfSlopes, AreNotKnownWhereALineIsNot) {
  std::vector<MeasuredFrfs> lines(3, MeasuredFrfs(2, {1.0, 1e-6}));
  lines[0].at(1, 0) = Measured{jointid::nan, jointid::nan};
  const FrfSlopes slopes({0, 1}, {1.0, 2.0, 3.0}, {&lines[0], &lines[1], &lines[2]}, 1);
  EXPECT_TRUE(std::isnan(slopes.of({1, 0}).real()));
  EXPECT_NEAR(std::abs(slopes.of({1, 1})), 0.0, 1e-9);
}

/// Rounding in an FRF that is zero by symmetry, with an error in proportion to itself as simulated noise has it.
TEST(FrfSlopes, AreNotKnownOfAnFrfThatIsZeroBySymmetry) {
  std::vector<MeasuredFrfs> lines(3, MeasuredFrfs(2, {1.0, {1e-6, 1e-6}}));
  for (std::size_t l = 0; l < 3; ++l) {
    const double value = 1e-14 * std::pow(-3.0, static_cast<double>(l));
    lines[l].at(1, 0) = Measured{value, {1e-6 * value * value, 1e-6 * value * value}};
  }
  const FrfSlopes slopes({0, 1}, {1.0, 2.0, 3.0}, {&lines[0], &lines[1], &lines[2]}, 1);
  EXPECT_TRUE(std::isnan(slopes.of({1, 0}).real()));
  EXPECT_NEAR(std::abs(slopes.of({1, 1})), 0.0, 1e-9);
}

/// Half the width beyond a bias, in standard deviations.
double beyond(double bias) {
  Intervals intervals(Eigen::MatrixXd::Identity(1, 1));
  intervals.add_bias({Eigen::VectorXd::Constant(1, bias)}, {});
  return 0.5 * (intervals.cost() * 2.0 * 1.959963984540054 - bias);
}

TEST(Intervals, OfABiasBetweenNoneAndAllHoldAtBothEnds) {
  EXPECT_NEAR(beyond(0.0), 1.959963984540054, 1e-6);
  EXPECT_NEAR(beyond(50.0), 1.644853626951473, 1e-6);
  const double c = beyond(1.0);  // Φ(c + 1) − Φ(−c) = 0.95
  EXPECT_NEAR(0.5 * (std::erf((c + 1.0) / std::sqrt(2.0)) + std::erf(c / std::sqrt(2.0))), 0.95, 1e-6);
}

/// The parts, or the last one alone, were warmer when the assembly was measured: their frequencies are lower in it.
problems::Problem warmed(const std::string& name, double shift, bool last_alone = false) {
  const std::vector<problems::Case> all = problems::all_cases();
  problems::Case rig = *std::ranges::find(all, name, &problems::Case::name);
  for (const problems::Structure& part : rig.substructures) {
    if (last_alone && &part != &rig.substructures.back()) continue;
    const std::vector<double> stiffness = part.matrix(problems::Kind::stiffness);
    problems::Matrix change(part.size(), std::vector<double>(part.size()));
    for (std::size_t i = 0; i < stiffness.size(); ++i) change[i / part.size()][i % part.size()] = -2.0 * shift * stiffness[i];
    rig.assembly.add(problems::Kind::stiffness, part.dofs(), change);
  }
  return problems::build(rig);
}

TEST(UnstatedErrors, AnotherTemperatureIsFoundBetweenLinesOf24Hz) {
  LikelihoodCase rig("rig1");
  rig.scene.noise.reset();
  rig.scene.frequency.step_hz = 24.0;
  const problems::Problem problem = warmed("rig1", 3e-4);
  Control control;
  control.threads = 1;
  control.judgement = Judgement::fit;
  const Solution found = solve(*problems::plan(rig.scene, problems::polluted(problem, 1, 0)), control);
  EXPECT_EQ(found.status, Status::doubtful) << found.message;
  const std::size_t place = found.message.find("with frequencies ");
  ASSERT_NE(place, std::string::npos) << found.message;
  EXPECT_NEAR(std::stod(found.message.substr(place + 17)), 0.03, 0.006) << found.message;
  double inside = 0.0;
  for (std::size_t u = 0; u < found.unknowns.size(); ++u) {
    const auto [low, high] = *found.unknowns[u].ci95;
    inside += low <= problem.unknowns[u].value && problem.unknowns[u].value <= high ? 1.0 : 0.0;
  }
  EXPECT_GE(inside, 18.0);  // of 20
}

/// Lines on resonances tell K(3,3) of A1, and take the shift of the parts' frequencies for it; the fit sets some of them aside. Of ten
/// seeds nine intervals of 95 % hold, and fewer than seven one time in a thousand.
TEST(UnstatedErrors, AnotherTemperatureIsInTheIntervalOfWhatFewLinesTell) {
  constexpr std::size_t told_by_few = 7;  // K(3,3)
  LikelihoodCase a1("A1", 0.01);
  problems::Problem problem = warmed("A1", 3e-4);
  std::get<frf::NoiseModel>(problem.noise).level = 0.01;
  Control control;
  control.threads = 1;
  control.judgement = Judgement::fit;
  std::size_t inside = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Solution found = solve(*problems::plan(a1.scene, problems::polluted(problem, seed, 0)), control);
    EXPECT_EQ(found.status, Status::doubtful) << seed << found.message;
    EXPECT_THAT(found.message, testing::HasSubstr("The assembly fits the parts better with frequencies 0.0")) << seed;
    const auto [low, high] = *found.unknowns[told_by_few].ci95;
    const double truth = problem.unknowns[told_by_few].value;
    inside += low <= truth && truth <= high;
  }
  EXPECT_GE(inside, 7u);
}

/// One line of the part is on a resonance. There its slopes are nearly all in proportion to its FRFs, and with their noise of 1 % the
/// stretch was found at a fifth of itself, in every other seed below three deviations. With weights of both parts of an FRF together it was
/// found at three quarters of itself.
TEST(UnstatedErrors, AnotherTemperatureOfOnePartIsFoundThoughItsFrfsHaveNoise) {
  LikelihoodCase a1("A1", 0.01);
  problems::Problem problem = warmed("A1", 2e-4, true);
  std::get<frf::NoiseModel>(problem.noise).level = 0.01;
  Control control;
  control.threads = 1;
  control.judgement = Judgement::fit;
  const std::string found_text = "A1_substructure_2.h5 fits the other files better with frequencies ";
  double mean = 0.0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Solution found = solve(*problems::plan(a1.scene, problems::polluted(problem, seed, 0)), control);
    EXPECT_EQ(found.status, Status::doubtful) << seed << found.message;
    const std::size_t place = found.message.find(found_text);
    ASSERT_NE(place, std::string::npos) << seed << found.message;
    mean += std::stod(found.message.substr(place + found_text.size())) / 4.0;
  }
  EXPECT_NEAR(mean, 0.02, 0.002);  // %, by single seeds ± 0.0018
}

}  // namespace
}  // namespace jointid::ident

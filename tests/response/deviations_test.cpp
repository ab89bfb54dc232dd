#include "response/harmonic/deviations.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "dense/lu.hpp"
#include "frf/set/frf_system.hpp"
#include "friction/law/laws.hpp"
#include "response/structure/frf_receptance.hpp"
#include "response/structure/matrix_receptance.hpp"

namespace jointid::response {
namespace {

constexpr double omega = 14.0;
const std::vector<int> harmonics = {1, 3, 5};

frf::Dof dof(int node) { return {node, frf::Direction::x, 1}; }

/// FRFs of a part with n masses between springs, the first to ground, at the harmonics of ω, with variances of a share of each
/// FRF.
frf::FrfSet part(Eigen::Index n, double spring, int first_node, double noise) {
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    k(i, i) += spring;
    if (i == 0) continue;
    k(i - 1, i - 1) += spring;
    k(i, i - 1) = k(i - 1, i) = -spring;
  }
  const Eigen::MatrixXd all = Eigen::MatrixXd::Identity(n, n);
  const MatrixReceptance receptance({all, 2e-3 * k, k}, Eigen::MatrixXd(n, 0), all, all);
  frf::FrfSet set;
  set.header.noise = frf::NoiseRecord::variance;
  for (Eigen::Index i = 0; i < n; ++i) set.header.response.push_back(dof(first_node + static_cast<int>(i)));
  set.header.reference = set.header.response;
  for (const int harmonic : harmonics) {
    set.header.frequency_hz.push_back(harmonic * omega / (2.0 * std::numbers::pi));
    const Eigen::MatrixXcd h = receptance.at(harmonic * omega);
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index j = 0; j < n; ++j) {
        set.values.push_back(h(i, j));
        const double variance = noise * noise * std::norm(h(i, j));
        set.variance.emplace_back(variance, 2.0 * variance);
      }
    }
  }
  return set;
}

void pollute(frf::FrfSet& set, std::mt19937_64& generator) {
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; i < set.values.size(); ++i) {
    const Complex variance = set.variance[i];
    set.values[i] += Complex(std::sqrt(variance.real()) * normal(generator), std::sqrt(variance.imag()) * normal(generator));
  }
}

HarmonicBalance balance_of(std::vector<frf::FrfSet> sets, const Joint& joint) {
  const auto system = frf::memory_system("parts", std::move(sets), frf::Composition::uncoupled);
  const auto structure = std::make_shared<FrfReceptance>(*system, std::vector<JointEnds>{{dof(2), dof(3)}},
                                                         std::vector<frf::Dof>{dof(1), dof(4)}, std::vector<frf::Dof>{dof(1)});
  return {structure, {joint}, Excitation::single(8.0), {.fixed = harmonics}};
}

std::vector<frf::FrfSet> parts(double noise) { return {part(2, 300.0, 1, noise), part(2, 120.0, 3, noise)}; }

Joint ren() { return {.name = "joint", .friction = friction::make_element("ren", std::vector{0.004, 1.5, 150.0})}; }

/// Scatter of the responses to FRFs with drawn errors against what is predicted: 600 draws tell a deviation to 3 %.
TEST(Deviations, AreTheScatterOfRepeatedMeasurements) {
  const double noise = 2e-3;
  const HarmonicBalance exact = balance_of(parts(noise), ren());
  const HarmonicSolution at = exact.solve(omega);
  ASSERT_TRUE(at.converged);
  const ResponseDeviations predicted = deviations(exact, at);
  std::mt19937_64 generator(5);
  Eigen::MatrixXd re = Eigen::MatrixXd::Zero(3, 2), im = re, size = re;
  constexpr int draws = 600;
  for (int i = 0; i < draws; ++i) {
    auto sets = parts(noise);
    for (auto& set : sets) pollute(set, generator);
    const HarmonicSolution drawn = balance_of(std::move(sets), ren()).solve(omega, 1.0, &at);
    ASSERT_TRUE(drawn.converged);
    re += (drawn.response - at.response).real().cwiseAbs2() / draws;
    im += (drawn.response - at.response).imag().cwiseAbs2() / draws;
    size += (drawn.response.cwiseAbs() - at.response.cwiseAbs()).cwiseAbs2() / draws;
  }
  for (Eigen::Index i = 0; i < re.size(); ++i) {
    EXPECT_NEAR(std::sqrt(re(i)) / predicted.parts(i).real(), 1.0, 0.15) << i;
    EXPECT_NEAR(std::sqrt(im(i)) / predicted.parts(i).imag(), 1.0, 0.15) << i;
    EXPECT_NEAR(std::sqrt(size(i)) / predicted.amplitude(i), 1.0, 0.15) << i;
  }
}

/// Intervals of 1.96 deviations, told from noisy FRFs alone (1 %), hold the response of the exact ones.
TEST(Deviations, IntervalsCoverTheExactResponse) {
  const double noise = 1e-2;
  const HarmonicSolution exact = balance_of(parts(noise), ren()).solve(omega);
  std::mt19937_64 generator(11);
  int inside = 0, all = 0;
  for (int i = 0; i < 200; ++i) {
    auto sets = parts(noise);
    for (auto& set : sets) pollute(set, generator);
    const HarmonicBalance balance = balance_of(std::move(sets), ren());
    const HarmonicSolution drawn = balance.solve(omega);
    ASSERT_TRUE(drawn.converged);
    const ResponseDeviations deviation = deviations(balance, drawn);
    const Eigen::MatrixXcd error = drawn.response - exact.response;
    for (Eigen::Index e = 0; e < error.size(); ++e) {
      inside += std::abs(error(e).real()) <= 1.96 * deviation.parts(e).real() ? 1 : 0;
      inside += std::abs(error(e).imag()) <= 1.96 * deviation.parts(e).imag() ? 1 : 0;
      all += 2;
    }
  }
  const double covered = static_cast<double>(inside) / all;
  EXPECT_GE(covered, 0.92);
  EXPECT_LE(covered, 0.97);
}

TEST(Deviations, OfParametersAreThoseOfDifferences) {
  const HarmonicBalance balance = balance_of(parts(0.0), ren());
  const HarmonicSolution at = balance.solve(omega);
  for (const std::size_t p : {0u, 1u, 2u, 4u}) {
    const double value = ren().values()[p], step = 1e-6 * std::max(1.0, value) * (p == 0 ? 1e-2 : 1.0);
    const auto moved = [&](double by) {
      std::vector<double> values = ren().values();
      values[p] += by;
      return balance_of(parts(0.0), ren().with(values)).solve(omega, 1.0, &at).response;
    };
    const Eigen::MatrixXcd slope = (moved(step) - moved(p == 4 ? 0.0 : -step)) / (p == 4 ? step : 2.0 * step);
    const Eigen::MatrixXcd found = deviations(balance, at, {{{0, p}, 0.5}}).parts;
    const double size = slope.cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < slope.size(); ++i) {
      EXPECT_NEAR(found(i).real(), 0.5 * std::abs(slope(i).real()), 1e-4 * size) << p << " " << i;
      EXPECT_NEAR(found(i).imag(), 0.5 * std::abs(slope(i).imag()), 1e-4 * size) << p << " " << i;
    }
  }
}

/// A linear joint: deviations go with the force, however small or large.
TEST(Deviations, NeitherOverflowNorVanish) {
  const Joint spring{.name = "joint", .friction = friction::make_element("spring", std::vector{150.0})};
  const HarmonicBalance balance = balance_of(parts(1e-2), spring);
  const ResponseDeviations one = deviations(balance, balance.solve(omega), {{{0, 0}, 5.0}});
  for (const double level : {1e-250, 1e-170, 1e70, 1e170, 1e250}) {
    const ResponseDeviations found = deviations(balance, balance.solve(omega, level), {{{0, 0}, 5.0}});
    EXPECT_LT((found.parts / level - one.parts).cwiseAbs().maxCoeff(), 1e-9 * one.parts.cwiseAbs().maxCoeff()) << level;
    EXPECT_LT((found.amplitude / level - one.amplitude).cwiseAbs().maxCoeff(), 1e-9 * one.amplitude.maxCoeff()) << level;
  }
}

/// A file that copies H_ij to H_ji has one error for both.
TEST(Deviations, CopiesShareTheirError) {
  auto sets = parts(2e-3);
  const auto structure = [&](std::vector<frf::FrfSet> of) {
    const auto system = frf::memory_system("parts", std::move(of), frf::Composition::uncoupled);
    return FrfReceptance(*system, {{dof(2), dof(3)}}, {dof(1)}, {dof(1)});
  };
  // Rows and columns: the joint's two ends and coordinate 1, so (1,2) and (2,1) of part one are both read.
  for (const std::size_t line : {0u, 4u, 8u}) sets[0].values[line + 1] = sets[0].values[line + 2];
  EXPECT_EQ(structure(sets).errors(omega).size(), 4u);
  sets[0].values[9] *= 1.0 + 1e-12;
  EXPECT_EQ(structure(sets).errors(omega).size(), 5u);
  for (const ReceptanceError& error : structure(sets).errors(omega)) EXPECT_EQ(error.shape.rows(), 2);
  for (auto& set : sets) {
    set.header.noise = frf::NoiseRecord::none;
    set.variance.clear();
  }
  EXPECT_TRUE(structure(sets).errors(omega).empty());
}

}  // namespace
}  // namespace jointid::response

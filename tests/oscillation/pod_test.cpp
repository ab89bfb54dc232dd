#include "oscillation/pod/pod.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/random.hpp"
#include "dense/cholesky.hpp"
#include "dense/eigen.hpp"
#include "dense/qr.hpp"
#include "oscillation/pod/mode_comparison.hpp"

namespace jointid::oscillation {
namespace {

Samples random_record(Eigen::Index samples, Eigen::Index channels, std::uint64_t seed) {
  Samples x(samples, channels);
  for (Eigen::Index i = 0; i < samples; ++i) {
    for (Eigen::Index k = 0; k < channels; ++k) {
      x(i, k) = normal_numbers({seed, 0, 0}, static_cast<std::uint64_t>(i * channels + k))[0] / (1.0 + static_cast<double>(k)) +
                3.0 * static_cast<double>(k);
    }
  }
  return x;
}

Eigen::MatrixXd random_mass(Eigen::Index size, std::uint64_t seed) {
  const Eigen::MatrixXd a = random_record(size, size, seed);
  return a * a.transpose() + Eigen::MatrixXd::Identity(size, size);
}

TEST(Pod, CoordinatesAreUncorrelatedWithTheValuesAsMeanSquares) {
  for (const bool weighted : {false, true}) {
    const Samples x = random_record(9000, 6, 3);
    const PodOptions options{true, weighted ? random_mass(6, 4) : Eigen::MatrixXd()};
    const Pod found = pod(x, options);
    const Eigen::MatrixXd a = pod_coordinates(found, x, 6, options);
    const Eigen::MatrixXd squares = a.transpose() * a / 9000.0;
    EXPECT_LT((squares - Eigen::MatrixXd(found.values.asDiagonal())).cwiseAbs().maxCoeff(), 1e-12 * found.values(0));
    const Eigen::MatrixXd mass = weighted ? options.mass : Eigen::MatrixXd::Identity(6, 6);
    EXPECT_LT((found.modes.transpose() * mass * found.modes - Eigen::MatrixXd::Identity(6, 6)).cwiseAbs().maxCoeff(), 1e-11);
    // What m modes leave is the rest of the values (theory, 1).
    const Samples rest = (x.rowwise() - found.mean.transpose()) - a.leftCols(2) * found.modes.leftCols(2).transpose();
    EXPECT_NEAR((rest * mass).cwiseProduct(rest).sum() / 9000.0, found.values.tail(4).sum(), 1e-10 * found.values.sum());
  }
}

TEST(Pod, KeepsValuesThatSquaresLose) {
  const Eigen::MatrixXd left = dense::orthonormal_columns(random_record(500, 4, 8));
  const Eigen::MatrixXd right = dense::orthonormal_columns(random_record(4, 4, 9));
  const Eigen::Vector4d sigma(1.0, 1e-4, 1e-10, 1e-13);
  const Pod found = pod(Samples(left * sigma.asDiagonal() * right.transpose()), {false, {}});
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(found.sigma(k), sigma(k), 1e-15);
  EXPECT_LT(std::abs(std::abs(found.modes.col(2).dot(right.col(2))) - 1.0), 1e-4);
}

TEST(Pod, IsTheSameForAnyBlocksAndThreads) {
  const Samples x = random_record(20000, 5, 11);
  const auto reader = [&x](Eigen::Index rows) {
    return [&x, rows, at_row = Eigen::Index{0}](std::span<double> room) mutable {
      const Eigen::Index count = std::min({rows, at(room.size()) / x.cols(), x.rows() - at_row});
      Eigen::Map<Samples>(room.data(), count, x.cols()) = x.middleRows(at_row, count);
      at_row += count;
      return static_cast<std::size_t>(count);
    };
  };
  const Pod one = pod(record_triangle(5, reader(4096), 1));
  for (const std::size_t threads : {2u, 3u, 8u}) {
    for (const Eigen::Index rows : {100, 4096, 100000}) {
      const Pod other = pod(record_triangle(5, reader(rows), threads));
      EXPECT_EQ(one.sigma, other.sigma);
      EXPECT_EQ(one.modes, other.modes);
    }
  }
  const Pod whole = pod(x);
  EXPECT_LT((whole.sigma - one.sigma).cwiseAbs().maxCoeff(), 1e-12 * one.sigma(0));
  EXPECT_LT((whole.mean - x.colwise().mean().transpose()).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Pod, MissingSamplesAreLeftOutAndCounted) {
  Samples x = random_record(300, 3, 5);
  const Pod whole = pod(Samples(x.bottomRows(298)));
  x(0, 1) = std::nan("");
  x(1, 2) = std::numeric_limits<double>::infinity();
  const Pod found = pod(x);
  EXPECT_EQ(found.samples, 298u);
  EXPECT_EQ(found.missing, 2u);
  EXPECT_LT((found.values - whole.values).cwiseAbs().maxCoeff(), 1e-13);
  x.setConstant(std::nan(""));
  EXPECT_THROW(pod(x), InputError);
  EXPECT_THROW(pod(random_record(50, 3, 5), {true, Eigen::MatrixXd::Zero(3, 3)}), InputError);
  EXPECT_THROW(pod(random_record(50, 3, 5), {true, Eigen::MatrixXd::Identity(2, 2)}), InputError);
}

/// Free undamped motion of three masses 1, 4, 0.3 on springs.
TEST(Pod, OfFreeMotionIsTheNormalModesOnlyInTheirInnerProduct) {
  Eigen::Matrix3d k;
  k << 2.0, -1.0, 0.0, -1.0, 2.0, -1.0, 0.0, -1.0, 1.0;
  const Eigen::MatrixXd mass = Eigen::Vector3d(1.0, 4.0, 0.3).asDiagonal();
  const auto normal = dense::symmetric_eigen(Eigen::MatrixXd(k), mass);
  const Eigen::Vector3d amplitude(1.0, 0.5, 0.2);
  Samples x(200000, 3);
  for (Eigen::Index i = 0; i < x.rows(); ++i) {
    Eigen::VectorXd q(3);
    for (int r = 0; r < 3; ++r) q(r) = amplitude(r) * std::cos(std::sqrt(normal.values(r)) * 0.05 * static_cast<double>(i));
    x.row(i) = (normal.vectors * q).transpose();
  }
  const Pod weighted = pod(x, {true, mass}), plain = pod(x);
  const Eigen::MatrixXd good = mode_cosines(weighted.modes, normal.vectors, mass);
  const Eigen::MatrixXd bad = mode_cosines(plain.modes, normal.vectors, mass);
  for (int r = 0; r < 3; ++r) {
    EXPECT_GT(good(r, r), 1.0 - 1e-6);
    EXPECT_NEAR(weighted.values(r), 0.5 * amplitude(r) * amplitude(r), 1e-3);
  }
  EXPECT_LT(bad.diagonal().minCoeff(), 0.97);
  const auto pairs = matched_modes(good);
  for (const ModePair& pair : pairs) EXPECT_EQ(pair.phi, pair.psi);
  EXPECT_NEAR(mode_assurance(plain.modes, plain.modes)(0, 0), 1.0, 1e-14);
}

/// φ = Ψv with known v: shares |v|/Σ|v| of unit ψ, whatever their scale, and what lies outside.
TEST(Pod, ContributionsAreTheCoordinatesInTheOtherModes) {
  const Eigen::MatrixXd mass = Eigen::Vector4d(1.0, 4.0, 0.3, 2.0).asDiagonal();
  Eigen::MatrixXd psi(4, 2);
  psi << 1.0, 0.2, 0.5, -1.0, 0.3, 0.4, 0.1, 0.9;
  Eigen::MatrixXd unit = psi;
  for (int k = 0; k < 2; ++k) unit.col(k) /= std::sqrt(psi.col(k).dot(mass * psi.col(k)));
  const Eigen::MatrixXd phi = unit * Eigen::Vector2d(0.9, -0.3);
  Eigen::MatrixXd scaled = psi;
  scaled.col(1) *= -70.0;
  const ModeContributions found = mode_contributions(phi, scaled, mass);
  EXPECT_NEAR(found.shares(0, 0), 0.75, 1e-12);
  EXPECT_NEAR(found.shares(0, 1), 0.25, 1e-12);
  EXPECT_NEAR(found.outside(0), 0.0, 1e-12);
  // What is at right angles to all of them.
  Eigen::VectorXd other = Eigen::Vector4d(0.3, -0.7, 0.1, 0.5);
  const Eigen::MatrixXd gram = unit.transpose() * mass * unit, right = unit.transpose() * mass * other;
  other -= unit * dense::solve_positive(gram, right);
  EXPECT_NEAR(mode_contributions(other, psi, mass).outside(0), 1.0, 1e-12);
  Eigen::MatrixXd twice(4, 2);
  twice << psi.col(0), 2.0 * psi.col(0);
  EXPECT_THROW(mode_contributions(phi, twice, mass), InputError);
}

TEST(Pod, FractionsOfBothConventions) {
  Pod two;
  two.sigma = Eigen::Vector2d(3.0, 1.0);
  EXPECT_DOUBLE_EQ(two.square_fractions()(0), 0.9);
  EXPECT_DOUBLE_EQ(two.sigma_fractions()(0), 0.75);
  EXPECT_EQ(two.modes_for(0.9), 1u);
  EXPECT_EQ(two.modes_for(0.99), 2u);
}

TEST(Pod, RankAboveNoise) {
  Samples x(4000, 12);
  for (Eigen::Index i = 0; i < x.rows(); ++i) {
    for (Eigen::Index k = 0; k < 12; ++k) {
      const double t = static_cast<double>(i);
      x(i, k) = std::sin(0.1 * t) * std::cos(0.4 * static_cast<double>(k)) +
                0.5 * std::sin(0.23 * t) * std::sin(0.9 * static_cast<double>(k)) +
                0.05 * normal_numbers({2, 0, 0}, static_cast<std::uint64_t>(i * 12 + k))[0];
    }
  }
  EXPECT_EQ(rank_above_noise(pod(x)), 2u);
}

}  // namespace
}  // namespace jointid::oscillation

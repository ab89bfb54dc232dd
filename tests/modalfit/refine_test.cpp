#include "modalfit/poles/refine.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "dense/cholesky.hpp"
#include "dense/pivoted_qr.hpp"
#include "frf/set/frf_source.hpp"
#include "modalfit/band/basis.hpp"
#include "modalfit/band/normal_block.hpp"
#include "modalfit/model/fit.hpp"
#include "problems/case/modal_set.hpp"

namespace jointid::modalfit {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr ModelKind hysteretic_real{Damping::hysteretic, true};

struct Sample {
  Band band;
  std::vector<std::size_t> entries;
  RefinedPoles refined;
};

/// The close pair on every 8th line with noise, refined from poles a little off.
Sample sample(const ModelKind& kind) {
  const auto set = problems::make_modal_set("modes-pair");
  const frf::FrfSet noisy = problems::polluted(set, 3, 0);
  auto source = frf::from_memory(noisy);
  std::vector<std::size_t> lines, responses = {0, 1, 2, 3}, references = {0, 1};
  for (std::size_t i = 0; i < noisy.header.lines(); i += 8) lines.push_back(i);
  Sample out{make_band(frf::load(*source, {lines, responses, references}), {}), {0, 1, 2, 5, 7}, {}};
  const double damping = kind.damping == Damping::hysteretic ? 0.0021 : 0.00105;
  out.refined = refine(out.band, out.entries, kind, {{100.01, damping}, {100.99, damping}});
  return out;
}

/// The whole least-squares problem, poles and coefficients: residuals and their Jacobian, dense.
struct Dense {
  VectorXd residual;
  MatrixXd jacobian;
};

Dense dense(const Sample& sample, const ModelKind& kind, const std::vector<Pole>& poles) {
  const RealBasis basis(make_basis(kind, poles, sample.band.frequency_hz, sample.band.scale_hz(), true));
  const Index rows = basis.columns.rows(), columns = basis.columns.cols(), parameters = 2 * basis.modes;
  const auto count = static_cast<Index>(sample.entries.size());
  Dense out{VectorXd(rows * count), MatrixXd::Zero(rows * count, parameters + columns * count)};
  for (Index k = 0; k < count; ++k) {
    const std::size_t entry = sample.entries[static_cast<std::size_t>(k)];
    const VectorXd weight = Eigen::Map<const VectorXd>(sample.band.weights(entry), rows);
    const VectorXd y = Eigen::Map<const VectorXd>(reinterpret_cast<const double*>(sample.band.value(entry)), rows);
    const MatrixXd x = weight.asDiagonal() * basis.columns;
    const VectorXd c = dense::RealPivotedQr(x).solve(weight.cwiseProduct(y));
    out.residual.segment(k * rows, rows) = weight.cwiseProduct(y) - x * c;
    out.jacobian.block(k * rows, parameters + k * columns, rows, columns) = x;
    for (Index mode = 0; mode < basis.modes; ++mode) {
      for (Index parameter = 0; parameter < 2; ++parameter) {
        for (Index own = 0; own < basis.per_mode; ++own) {
          out.jacobian.block(k * rows, 2 * mode + parameter, rows, 1) +=
              weight.cwiseProduct(basis.derivatives.col((2 * mode + parameter) * basis.per_mode + own)) * c(mode * basis.per_mode + own);
        }
      }
    }
  }
  return out;
}

TEST(Refine, CovarianceIsThePoleBlockOfTheInverseFisherInformation) {
  for (const ModelKind& kind : {hysteretic_real, ModelKind{Damping::viscous, false}}) {
    const Sample at = sample(kind);
    ASSERT_TRUE(at.refined.converged);
    const Dense problem = dense(at, kind, at.refined.poles);
    const VectorXd scale = problem.jacobian.colwise().norm().cwiseInverse();
    const MatrixXd scaled = problem.jacobian * scale.asDiagonal();
    const MatrixXd inverse = dense::solve_positive(scaled.transpose() * scaled, MatrixXd::Identity(scaled.cols(), scaled.cols()));
    for (Index i = 0; i < 4; ++i) {
      for (Index j = 0; j < 4; ++j) {
        const double expected = scale(i) * inverse(i, j) * scale(j);
        const double size = std::sqrt(inverse(i, i) * inverse(j, j)) * scale(i) * scale(j);
        EXPECT_NEAR(at.refined.covariance[static_cast<std::size_t>(4 * i + j)] / size, expected / size, 1e-6);
      }
    }
    EXPECT_NEAR(at.refined.cost / problem.residual.squaredNorm(), 1.0, 1e-9);
    EXPECT_EQ(at.refined.freedom, static_cast<double>(problem.jacobian.rows() - problem.jacobian.cols()));
  }
}

TEST(Refine, NoPoleNearbyHasASmallerCost) {
  const Sample at = sample(hysteretic_real);
  const auto cost = [&](const std::vector<Pole>& poles) { return dense(at, hysteretic_real, poles).residual.squaredNorm(); };
  const double least = cost(at.refined.poles);
  for (std::size_t r = 0; r < 2; ++r) {
    for (const double deviations : {-0.2, 0.2}) {
      std::vector<Pole> poles = at.refined.poles;
      poles[r].frequency_hz *= 1.0 + deviations * std::sqrt(at.refined.covariance[2 * r * 5]);
      EXPECT_GT(cost(poles), least);
      poles = at.refined.poles;
      poles[r].damping += deviations * std::sqrt(at.refined.covariance[(2 * r + 1) * 5]);
      EXPECT_GT(cost(poles), least);
    }
  }
}

TEST(Refine, StopsWhenAsked) {
  const Sample at = sample(hysteretic_real);
  const auto stopped = refine(at.band, at.entries, hysteretic_real, {{99.0, 0.01}, {102.0, 0.01}}, {}, [] { return true; });
  EXPECT_FALSE(stopped.converged);
  EXPECT_EQ(stopped.iterations, 0u);
}

}  // namespace
}  // namespace jointid::modalfit

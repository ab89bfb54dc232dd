#include "ident/variance/covariance_law.hpp"

#include <algorithm>
#include <cmath>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "base/statistics.hpp"
#include "dense/cholesky.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr int most_iterations = 40;
constexpr double settled = 1e-3;  ///< relative change of variances in an iteration

/// f(r, sample) for every response, its median over the samples.
template <class Function>
VectorXd medians(const std::vector<CovarianceSample>& samples, Function f) {
  VectorXd out(samples.front().frf.size());
  for (Index r = 0; r < out.size(); ++r) {
    std::vector<double> all;
    for (const CovarianceSample& sample : samples) all.push_back(f(r, sample));
    out[r] = median(std::move(all));
  }
  return out;
}

/// K − K·mean·K and the like, Hermitian to the last bit.
MatrixXcd updated(const MatrixXcd& law, const MatrixXcd& mean) {
  const MatrixXcd next = law - law * mean * law;
  return 0.5 * (next + next.adjoint());
}

double change(const MatrixXcd& from, const MatrixXcd& to, const VectorXd& total) {
  return ((to - from).diagonal().real().cwiseAbs().array() / total.array()).maxCoeff();
}

/// One step: with G = Σ⁻¹ − Σ⁻¹ S Σ⁻¹ the conditional expectations of both parts' covariances are K − K Dᴴ G D K and B − B G B.
/// Returns by how much variances changed, in parts of what both parts make.
double improve(const std::vector<CovarianceSample>& samples, const VectorXd& square, CovarianceLaw& law) {
  const Index size = law.constant.rows();
  MatrixXcd of_proportional = MatrixXcd::Zero(size, size), of_constant = of_proportional;
  for (const CovarianceSample& sample : samples) {
    MatrixXcd sigma = law(sample.frf, 1.0);
    sigma.diagonal() *= 1.0 + 1e-12;
    const MatrixXcd inverse = dense::solve_positive(sigma, MatrixXcd::Identity(size, size));
    const MatrixXcd g = inverse - inverse * sample.covariance * inverse;
    of_constant += g;
    of_proportional += sample.frf.conjugate().asDiagonal() * g * sample.frf.asDiagonal();
  }
  const double share = 1.0 / static_cast<double>(samples.size());
  const CovarianceLaw next{updated(law.proportional, share * of_proportional), updated(law.constant, share * of_constant)};
  const VectorXd total = law.constant.diagonal().real() + square.cwiseProduct(law.proportional.diagonal().real());
  const VectorXd of_the_blow = (next.proportional - law.proportional).diagonal().real().cwiseAbs();
  const double moved =
      change(law.constant, next.constant, total) + (square.array() * of_the_blow.array() / total.array()).maxCoeff();
  law = next;
  return moved;
}

}  // namespace

MatrixXcd CovarianceLaw::operator()(const VectorXcd& frf, double squared_factor) const {
  MatrixXcd out = frf.asDiagonal() * proportional * frf.conjugate().asDiagonal();
  out += squared_factor * constant;
  return out;
}

CovarianceLaw fit_covariance(std::vector<CovarianceSample> samples) {
  if (samples.empty()) return {};
  const auto variance = [](Index r, const CovarianceSample& sample) { return std::max(sample.covariance(r, r).real(), 1e-300); };
  const VectorXd scale = medians(samples, variance).cwiseSqrt(), back = scale.cwiseInverse();
  for (CovarianceSample& sample : samples) {
    sample.frf = back.asDiagonal() * sample.frf;
    sample.covariance = (back.asDiagonal() * sample.covariance * back.asDiagonal()).eval();
  }
  const auto square_of = [](Index r, const CovarianceSample& sample) { return std::norm(sample.frf[r]); };
  const VectorXd square = medians(samples, square_of);
  const VectorXd relative = medians(samples, [&](Index r, const CovarianceSample& sample) {
    return variance(r, sample) / std::max(square_of(r, sample), 1e-300);
  });
  CovarianceLaw law{(0.5 * relative).cast<Complex>().asDiagonal(), VectorXcd::Constant(scale.size(), 0.5).asDiagonal()};
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    if (improve(samples, square, law) < settled) break;
  }
  law.constant = (scale.asDiagonal() * law.constant * scale.asDiagonal()).eval();
  return law;
}

}  // namespace jointid::ident

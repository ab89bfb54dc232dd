#include "modalfit/model/uncertainty.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "modalfit/band/normal_block.hpp"

namespace jointid::modalfit {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double most_correction = 4.0;
/// An FRF tells a frequency when it has this share of the information of the one that tells it best.
constexpr double telling_share = 0.02;

/// What one FRF adds, per parameter.
struct Share {
  ArrayXd information, fourth, misfit;  ///< Σd², Σd⁴, Σd²r² over its rows, d of pole_rows, r the residual over σ
  VectorXd gradient;
  std::vector<double> own_step;  ///< [N] of ln f by itself
};

Share share_of(const NormalBlock& block, const RealBasis& basis) {
  const MatrixXd rows = block.pole_rows(basis);
  const MatrixXd squares = rows.cwiseAbs2();
  Share share;
  share.information = squares.colwise().sum().transpose().array();
  share.fourth = squares.cwiseAbs2().colwise().sum().transpose().array();
  share.misfit = (squares.transpose() * block.residual().cwiseAbs2()).array();
  share.gradient = rows.transpose() * block.residual();
  for (Index i = 0; i < rows.cols(); i += 2) {
    const double a = share.information(i), b = rows.col(i).dot(rows.col(i + 1)), c = share.information(i + 1);
    const double determinant = a * c - b * b;
    share.own_step.push_back(determinant > 0.0 ? (c * share.gradient(i) - b * share.gradient(i + 1)) / determinant : 0.0);
  }
  return share;
}

/// Mean square residual weighted by information, made good for what the fit has taken of the few rows at a narrow peak: the poles, and
/// two coefficients of each FRF that tells them.
ArrayXd weighted_misfit(const std::vector<Share>& shares, Index parameters) {
  ArrayXd information = ArrayXd::Zero(parameters), fourth = information, misfit = information, of_frfs = information;
  for (const Share& share : shares) {
    information += share.information;
    fourth += share.fourth;
    misfit += share.misfit;
    of_frfs += share.information.square();
  }
  ArrayXd out = ArrayXd::Ones(parameters);
  for (Index i = 0; i < parameters; ++i) {
    if (!(information(i) > 0.0) || !(fourth(i) > 0.0)) continue;
    const double rows = information(i) * information(i) / fourth(i);
    const double taken = 2.0 + 2.0 * information(i) * information(i) / of_frfs(i);
    out(i) = misfit(i) / information(i) * rows / std::max(rows - taken, rows / most_correction);
  }
  return out;
}

/// Variance by the scatter of groups of FRFs over that of C; `group` of each entry.
template <class Group>
ArrayXd group_scatter(const std::vector<Share>& shares, std::size_t groups, const MatrixXd& covariance, Group group) {
  const Index parameters = covariance.rows();
  std::vector<VectorXd> gradient(groups, VectorXd::Zero(parameters));
  std::vector<ArrayXd> information(groups, ArrayXd::Zero(parameters));
  for (std::size_t k = 0; k < shares.size(); ++k) {
    if (shares[k].gradient.size() == 0) continue;
    gradient[group(k)] += shares[k].gradient;
    information[group(k)] += shares[k].information;
  }
  ArrayXd sum = ArrayXd::Zero(parameters), squares = sum, scatter = sum;
  for (std::size_t g = 0; g < groups; ++g) {
    sum += information[g];
    squares += information[g].square();
    scatter += (covariance * gradient[g]).array().square();
  }
  ArrayXd out = ArrayXd::Zero(parameters);
  for (Index i = 0; i < parameters; ++i) {
    const double count = squares(i) > 0.0 ? sum(i) * sum(i) / squares(i) : 0.0;
    if (count > 1.5 && covariance(i, i) > 0.0) out(i) = count / (count - 1.0) * scatter(i) / covariance(i, i);
  }
  return out;
}

std::vector<std::array<double, 2>> own_frequencies(const std::vector<Share>& shares, const std::vector<Pole>& poles) {
  std::vector<std::array<double, 2>> out;
  for (std::size_t r = 0; r < poles.size(); ++r) {
    const auto i = static_cast<Index>(2 * r);
    double best = 0.0;
    for (const Share& share : shares) best = share.information.size() > 0 ? std::max(best, share.information(i)) : best;
    std::array<double, 2> range = {poles[r].frequency_hz, poles[r].frequency_hz};
    for (const Share& share : shares) {
      if (share.information.size() == 0 || !(share.information(i) > telling_share * best)) continue;
      const double own = poles[r].frequency_hz * (1.0 + share.own_step[r]);
      range = {std::min(range[0], own), std::max(range[1], own)};
    }
    out.push_back(range);
  }
  return out;
}

}  // namespace

PoleScatter pole_scatter(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind, const RefinedPoles& refined) {
  const Index parameters = 2 * at(refined.poles.size());
  if (parameters == 0) return {};
  const RealBasis basis(make_basis(kind, refined.poles, band.frequency_hz, band.scale_hz(), true));
  std::vector<Share> shares(entries.size());
  tbb::parallel_for(std::size_t{0}, entries.size(), [&](std::size_t k) {
    const NormalBlock block(basis, band, entries[k]);
    shares[k] = block.equations() > 0.0 ? share_of(block, basis)
                                        : Share{ArrayXd::Zero(parameters), ArrayXd::Zero(parameters), ArrayXd::Zero(parameters),
                                                VectorXd::Zero(parameters), std::vector<double>(refined.poles.size())};
  });
  const MatrixXd covariance = Eigen::Map<const MatrixXd>(refined.covariance.data(), parameters, parameters);
  ArrayXd variance = weighted_misfit(shares, parameters).max(1.0);
  variance = variance.max(group_scatter(shares, entries.size(), covariance, [](std::size_t k) { return k; }));
  variance = variance.max(group_scatter(shares, band.responses, covariance, [&](std::size_t k) { return entries[k] / band.references; }));
  variance = variance.max(group_scatter(shares, band.references, covariance, [&](std::size_t k) { return entries[k] % band.references; }));
  PoleScatter out;
  for (Index i = 0; i < parameters; ++i) out.factor.push_back(std::sqrt(variance(i)));
  out.own_hz = own_frequencies(shares, refined.poles);
  return out;
}

void widen(std::vector<double>& covariance, const std::vector<double>& factor) {
  const std::size_t n = factor.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) covariance[i * n + j] *= factor[i] * factor[j];
  }
}

}  // namespace jointid::modalfit

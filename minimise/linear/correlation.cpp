#include "minimise/linear/correlation.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "dense/blas.hpp"
#include "dense/cholesky.hpp"

namespace jointid::minimise {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;

/// Which of the elements that a row names depend on each other, directly or through others.
std::vector<std::vector<Index>> dependent(const MatrixXcd& covariance) {
  std::vector<bool> taken(static_cast<std::size_t>(covariance.rows()), false);
  std::vector<std::vector<Index>> out;
  for (Index first = 0; first < covariance.rows(); ++first) {
    if (taken[static_cast<std::size_t>(first)]) continue;
    std::vector<Index> group = {first};
    taken[static_cast<std::size_t>(first)] = true;
    for (std::size_t i = 0; i < group.size(); ++i) {
      for (Index other = 0; other < covariance.rows(); ++other) {
        if (taken[static_cast<std::size_t>(other)] || covariance(other, group[i]) == Complex(0.0)) continue;
        taken[static_cast<std::size_t>(other)] = true;
        group.push_back(other);
      }
    }
    std::ranges::sort(group);
    if (group.size() > 1) out.push_back(std::move(group));
  }
  return out;
}

MatrixXcd factor_of(const MatrixXcd& correlation) {
  for (double share = 1e-12;; share *= 10.0) {
    MatrixXcd factor = correlation;
    factor.diagonal().array() += share;
    factor /= 1.0 + share;
    if (dense::cholesky_in_place(factor)) return factor.triangularView<Eigen::Lower>();
    if (share > 1.0) return MatrixXcd::Identity(correlation.rows(), correlation.cols());
  }
}

/// Of real and imaginary parts, from E[e e^H] and E[e eᵀ], by their variances: 1 on the diagonal.
Eigen::MatrixXd part_correlation(const MatrixXcd& covariance, const MatrixXcd& relation, const VectorXcd& variance) {
  const Index n = covariance.rows();
  Eigen::MatrixXd out(2 * n, 2 * n);
  out.topLeftCorner(n, n) = 0.5 * (covariance + relation).real();
  out.bottomRightCorner(n, n) = 0.5 * (covariance - relation).real();
  out.bottomLeftCorner(n, n) = 0.5 * (covariance + relation).imag();  // E[Im e_i Re e_j]
  out.topRightCorner(n, n) = out.bottomLeftCorner(n, n).transpose();
  Eigen::VectorXd scale(2 * n);
  scale << variance.real().cwiseSqrt().cwiseInverse(), variance.imag().cwiseSqrt().cwiseInverse();
  out = (scale.asDiagonal() * out * scale.asDiagonal()).eval();
  out.diagonal().setOnes();
  return out;
}

Eigen::MatrixXd factor_of(const Eigen::MatrixXd& correlation) {
  for (double share = 1e-12;; share *= 10.0) {
    Eigen::MatrixXd factor = correlation;
    factor.diagonal().array() += share;
    factor /= 1.0 + share;
    if (dense::cholesky_in_place(factor)) return factor.triangularView<Eigen::Lower>();
    if (share > 1.0) return Eigen::MatrixXd::Identity(correlation.rows(), correlation.cols());
  }
}

/// change(L, some) of every group, some [n,1], or of its parts [2n,1].
template <class Change>
void each_group(const std::vector<Correlation::Group>& groups, std::span<Complex> errors, Change change) {
  for (const auto& [elements, factor, parts] : groups) {
    const Index n = at(elements.size());
    MatrixXcd some(n, 1);
    for (Index i = 0; i < n; ++i) some(i, 0) = errors[elements[static_cast<std::size_t>(i)]];
    if (parts.size() > 0) {
      Eigen::MatrixXd both(2 * n, 1);
      both << some.real(), some.imag();
      change(parts, both);
      some.real() = both.topRows(n);
      some.imag() = both.bottomRows(n);
    } else {
      change(factor, some);
    }
    for (Index i = 0; i < n; ++i) errors[elements[static_cast<std::size_t>(i)]] = some(i, 0);
  }
}

}  // namespace

Correlation::Correlation(std::size_t elements, std::vector<Group> groups) : groups_(std::move(groups)), places_(elements) {
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    for (std::size_t row = 0; row < groups_[g].elements.size(); ++row) places_[groups_[g].elements[row]] = {g, row};
  }
}

Correlation Correlation::of(std::size_t elements, const std::vector<std::size_t>& some, const MatrixXcd& covariance,
                            const Eigen::VectorXd& variance) {
  std::vector<Group> groups;
  for (const std::vector<Index>& members : dependent(covariance)) {
    Group group;
    MatrixXcd correlation = covariance(members, members);
    for (Index i = 0; i < correlation.rows(); ++i) {
      const Index element = members[static_cast<std::size_t>(i)];
      group.elements.push_back(some[static_cast<std::size_t>(element)]);
      const double scale = 1.0 / std::sqrt(variance[element]);
      correlation.row(i) *= scale;
      correlation.col(i) *= scale;
      correlation(i, i) = 1.0;
    }
    group.factor = factor_of(correlation);
    groups.push_back(std::move(group));
  }
  return Correlation(elements, std::move(groups));
}

Correlation Correlation::of(std::size_t elements, const std::vector<std::size_t>& some, const MatrixXcd& covariance,
                            const MatrixXcd& relation, const VectorXcd& variance) {
  Correlation out = of(elements, some, covariance, variance.real() + variance.imag());
  if (relation.size() == 0) return out;
  for (Group& group : out.groups_) {
    std::vector<Index> members;
    for (const std::size_t element : group.elements) {
      members.push_back(std::ranges::lower_bound(some, element) - some.begin());
    }
    const MatrixXcd own = relation(members, members);
    if (own.isZero(0.0)) continue;
    group.parts = factor_of(part_correlation(covariance(members, members), own, variance(members)));
  }
  return out;
}

bool Correlation::is_circular() const {
  return std::ranges::all_of(groups_, [](const Group& group) { return group.parts.size() == 0; });
}

void Correlation::whiten(std::span<Complex> errors) const {
  each_group(groups_, errors, [](const auto& factor, auto& some) { dense::solve_lower(factor, some); });
}

void Correlation::colour(std::span<Complex> errors) const {
  each_group(groups_, errors,
             [](const auto& factor, auto& some) { some = (factor.template triangularView<Eigen::Lower>() * some).eval(); });
}

std::size_t Correlation::bytes() const {
  std::size_t sum = places_.size() * sizeof(Place);
  for (const Group& group : groups_) {
    sum += static_cast<std::size_t>(group.factor.size()) * sizeof(Complex) + static_cast<std::size_t>(group.parts.size()) * sizeof(double);
  }
  return sum;
}

}  // namespace jointid::minimise

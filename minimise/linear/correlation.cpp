#include "minimise/linear/correlation.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "dense/blas.hpp"

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

template <class Change>
void each_group(const std::vector<Correlation::Group>& groups, std::span<Complex> errors, Change change) {
  for (const auto& [elements, factor] : groups) {
    MatrixXcd some(at(elements.size()), 1);
    for (std::size_t i = 0; i < elements.size(); ++i) some(at(i), 0) = errors[elements[i]];
    change(factor, some);
    for (std::size_t i = 0; i < elements.size(); ++i) errors[elements[i]] = some(at(i), 0);
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

void Correlation::whiten(std::span<Complex> errors) const {
  each_group(groups_, errors, [](const MatrixXcd& factor, MatrixXcd& some) { dense::solve_lower(factor, some); });
}

void Correlation::colour(std::span<Complex> errors) const {
  each_group(groups_, errors,
             [](const MatrixXcd& factor, MatrixXcd& some) { some = (factor.triangularView<Eigen::Lower>() * some).eval(); });
}

std::size_t Correlation::bytes() const {
  std::size_t sum = places_.size() * sizeof(Place);
  for (const Group& group : groups_) sum += static_cast<std::size_t>(group.factor.size()) * sizeof(Complex);
  return sum;
}

}  // namespace jointid::minimise

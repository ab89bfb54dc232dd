#include "ident/likelihood/findings/weak_combinations.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/eigen.hpp"
#include "dense/eigen.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t most = 3;
constexpr double part = 0.3;       ///< of the largest, to take part in a combination
constexpr double nearly_zero = 1e-3;  ///< of the largest value with the same unit

std::vector<Index> members_of(const VectorXd& v) {
  const double largest = v.cwiseAbs().maxCoeff();
  std::vector<Index> members;
  for (Index i = 0; i < v.size(); ++i) {
    if (std::abs(v[i]) >= part * largest) members.push_back(i);
  }
  std::ranges::stable_sort(members, [&](Index a, Index b) { return std::abs(v[a]) > std::abs(v[b]); });
  return members;
}

LinearCombination combination(const dense::SymmetricEigen& eigen, Index which, const std::vector<Index>& members,
                        const std::vector<std::string>& names) {
  LinearCombination out;
  const double sign = eigen.vectors(0, which) < 0.0 ? -1.0 : 1.0;
  for (std::size_t i = 0; i < members.size(); ++i) {
    out.names.push_back(names[static_cast<std::size_t>(members[i])]);
    out.factors.push_back(sign * eigen.vectors(at(i), which));
  }
  out.deviation = std::sqrt(std::max(0.0, eigen.values[which]));
  return out;
}

WeakCombination describe(const MatrixXd& covariance, const std::vector<Index>& members, const std::vector<std::string>& names) {
  const dense::SymmetricEigen eigen = dense::symmetric_eigen(MatrixXd(covariance(members, members)));
  WeakCombination out;
  const auto last = at(members.size()) - 1;
  out.worst = combination(eigen, last, members, names);
  if (members.size() == 1) return out;
  out.best = combination(eigen, 0, members, names);
  const Index a = members[0], b = members[1];
  out.correlation = covariance(a, b) / std::sqrt(covariance(a, a) * covariance(b, b));
  return out;
}

}  // namespace

std::vector<double> relative_scales(const Plan& plan, const std::vector<double>& values) {
  const auto unknown = [&](std::size_t column) -> const restrictions::Unknown& {
    return plan.restriction.unknowns[plan.columns->unknown_of(column)];
  };
  std::vector<double> scales;
  for (std::size_t column = 0; column < values.size(); ++column) {
    double same_unit = 0.0, same_matrix = 0.0;
    for (std::size_t other = 0; other < values.size(); ++other) {
      if (unknown(other).kind != unknown(column).kind) continue;
      same_matrix = std::max(same_matrix, std::abs(values[other]));
      if (unknown(other).unit == unknown(column).unit) same_unit = std::max(same_unit, std::abs(values[other]));
    }
    const double own = std::abs(values[column]);
    scales.push_back(same_unit == 0.0 ? same_matrix : own > nearly_zero * same_unit ? own : same_unit);
  }
  return scales;
}

std::vector<WeakCombination> weak_combinations(const MatrixXd& covariance, const std::vector<std::string>& names) {
  std::vector<WeakCombination> out;
  if (covariance.size() == 0 || !covariance.allFinite()) return out;
  const dense::SymmetricEigen eigen = dense::symmetric_eigen(covariance);
  std::set<std::set<Index>> told;
  for (Index which = covariance.rows() - 1; which >= 0 && out.size() < most; --which) {
    const std::vector<Index> members = members_of(eigen.vectors.col(which));
    if (told.emplace(members.begin(), members.end()).second) out.push_back(describe(covariance, members, names));
  }
  return out;
}

}  // namespace jointid::ident

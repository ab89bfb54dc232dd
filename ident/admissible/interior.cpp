#include "ident/admissible/interior.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "base/eigen.hpp"
#include "ident/admissible/semidefinite_least_squares.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double price = 1e-4;  ///< of a unit of θ over one of t: enters squared
constexpr double room = 1e-5;
constexpr Index few_unknowns = 150;  ///< that one problem may have: its steps cost the cube of them

/// The same condition with its unknowns in units of `unit`.
SymmetricBlock in_units(SymmetricBlock block, const VectorXd& unit) {
  for (std::size_t u = 0; u < block.unknowns.size(); ++u) {
    for (BlockEntry& entry : block.coefficients[u]) entry.value *= unit[block.unknowns[u]];
  }
  return block;
}

/// Sizes of unknowns as known parts tell: S₀ over the largest coefficient; 1 where nothing tells.
VectorXd units_of(const std::vector<SymmetricBlock>& blocks, Index unknowns) {
  VectorXd unit = VectorXd::Zero(unknowns);
  double any = 0.0;
  for (const SymmetricBlock& block : blocks) {
    const double known = block.constant.cwiseAbs().maxCoeff();
    for (std::size_t u = 0; u < block.unknowns.size(); ++u) {
      double largest = 0.0;
      for (const BlockEntry& entry : block.coefficients[u]) largest = std::max(largest, std::abs(entry.value));
      if (largest > 0.0) unit[block.unknowns[u]] = std::max(unit[block.unknowns[u]], known / largest);
    }
  }
  any = unit.maxCoeff();
  for (double& each : unit) each = each > 0.0 ? each : (any > 0.0 ? any : 1.0);
  return unit;
}

}  // namespace

std::optional<VectorXd> interior_point(const std::vector<SymmetricBlock>& blocks, const AdmissibleSet& set, Index unknowns) {
  const bool tied = set.directions.size() > 0;
  const VectorXd unit = units_of(blocks, unknowns);
  const VectorXd inverse = unit.cwiseInverse();
  const MatrixXd directions = tied ? MatrixXd(inverse.asDiagonal() * set.directions) : MatrixXd(MatrixXd::Identity(unknowns, unknowns));
  // Unknowns θ/unit and t; x = (price·w, t − 1).
  VectorXd origin = VectorXd::Zero(unknowns + 1);
  if (tied) origin.head(unknowns) = inverse.asDiagonal() * set.offset;
  origin[unknowns] = 1.0;
  MatrixXd basis = MatrixXd::Zero(unknowns + 1, directions.cols() + 1);
  for (Index w = 0; w < directions.cols(); ++w) {
    const double size = directions.col(w).cwiseAbs().maxCoeff();
    basis.col(w).head(unknowns) = directions.col(w) / (price * (size > 0.0 ? size : 1.0));
  }
  basis(unknowns, directions.cols()) = 1.0;
  std::vector<SymmetricBlock> raised;
  for (const SymmetricBlock& block : blocks) {
    SymmetricBlock own = in_units(block, unit);
    double largest = own.constant.cwiseAbs().maxCoeff();
    for (const auto& entries : own.coefficients) {
      for (const BlockEntry& entry : entries) largest = std::max(largest, std::abs(entry.value));
    }
    own = scaled(own, VectorXd::Constant(own.size(), 1.0 / std::sqrt(largest)));
    own.unknowns.push_back(unknowns);
    own.coefficients.emplace_back();
    for (Index i = 0; i < own.size(); ++i) own.coefficients.back().push_back({i, i, -1.0});
    raised.push_back(std::move(own));
  }
  const SemidefiniteFit fit = solve_semidefinite(raised, origin, basis);
  const VectorXd found = origin + basis * fit.x;
  const bool inside =
      std::ranges::all_of(raised, [&](const SymmetricBlock& block) { return least_eigenvalue(block.at(found)) > -0.5 * room; });
  if (!inside || !(found[unknowns] > room)) return std::nullopt;
  return unit.asDiagonal() * found.head(unknowns);
}

std::optional<VectorXd> interior_point_by_parts(const std::vector<SymmetricBlock>& blocks, const AdmissibleSet& set, Index unknowns) {
  if (unknowns <= few_unknowns || set.directions.size() > 0) return interior_point(blocks, set, unknowns);
  std::vector<Index> leader(static_cast<std::size_t>(unknowns));
  std::iota(leader.begin(), leader.end(), Index{0});
  const auto find = [&](Index u) {
    while (leader[static_cast<std::size_t>(u)] != u) u = leader[static_cast<std::size_t>(u)];
    return u;
  };
  for (const SymmetricBlock& block : blocks) {
    for (const Index u : block.unknowns) leader[static_cast<std::size_t>(find(u))] = find(block.unknowns.front());
  }
  std::map<Index, std::vector<SymmetricBlock>> parts;
  for (const SymmetricBlock& block : blocks) parts[block.unknowns.empty() ? -1 : find(block.unknowns.front())].push_back(block);
  VectorXd out = VectorXd::Zero(unknowns);
  for (auto& [first, own] : parts) {
    std::vector<Index> used;
    for (const SymmetricBlock& block : own) used.insert(used.end(), block.unknowns.begin(), block.unknowns.end());
    std::ranges::sort(used);
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (SymmetricBlock& block : own) {
      for (Index& u : block.unknowns) u = std::ranges::lower_bound(used, u) - used.begin();
    }
    const auto found = interior_point(own, AdmissibleSet(), std::max<Index>(1, at(used.size())));
    if (!found) return std::nullopt;
    for (Index k = 0; k < at(used.size()); ++k) out[used[static_cast<std::size_t>(k)]] = (*found)[k];
  }
  return out;
}

}  // namespace jointid::ident

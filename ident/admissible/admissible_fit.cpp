#include "ident/admissible/admissible_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ident/admissible/semidefinite_least_squares.hpp"
#include "ident/admissible/sparse_semidefinite.hpp"
#include "ident/admissible/tied_least_squares.hpp"

namespace jointid::ident {
namespace {

using Eigen::VectorXd;

bool inside(const std::vector<SymmetricBlock>& blocks, const VectorXd& theta) {
  return std::ranges::all_of(blocks, [&](const SymmetricBlock& block) {
    const VectorXd scale = balance(block, theta);
    return least_eigenvalue(scale.asDiagonal() * block.at(theta) * scale.asDiagonal()) >= 0.0;
  });
}

/// Of each unknown the first of those that blocks connect it with.
std::vector<Eigen::Index> first_connected(const AdmissibleSet& set, Eigen::Index unknowns) {
  std::vector<Eigen::Index> first(static_cast<std::size_t>(unknowns));
  std::iota(first.begin(), first.end(), Eigen::Index{0});
  for (bool changes = true; changes;) {
    changes = false;
    for (const Inequality& inequality : set.inequalities) {
      Eigen::Index least = unknowns;
      for (const Eigen::Index u : inequality.block.unknowns) least = std::min(least, first[static_cast<std::size_t>(u)]);
      for (const Eigen::Index u : inequality.block.unknowns) {
        Eigen::Index& own = first[static_cast<std::size_t>(u)];
        changes = changes || own != least;
        own = least;
      }
    }
  }
  return first;
}

/// How large a point inside a cone has to be to be beside an estimate: of each unknown, as large as those that blocks connect it with. A
/// soft joint is not moved by what is rounding of a stiff one.
VectorXd sizes_inside(const AdmissibleSet& set, const VectorXd& estimate) {
  const std::vector<Eigen::Index> first = first_connected(set, estimate.size());
  VectorXd own = VectorXd::Zero(estimate.size()), inside = own, out = own;
  for (Eigen::Index u = 0; u < estimate.size(); ++u) {
    const Eigen::Index of = first[static_cast<std::size_t>(u)];
    own[of] = std::max(own[of], std::abs(estimate[u]));
    inside[of] = std::max(inside[of], std::abs(set.inside[u]));
  }
  for (Eigen::Index u = 0; u < estimate.size(); ++u) {
    const Eigen::Index of = first[static_cast<std::size_t>(u)];
    out[u] = inside[of] > 0.0 ? own[of] / inside[of] : 0.0;
  }
  return out;
}

/// Away from the limits by what rounding may have crossed them: a matrix that vanishes has no largest eigenvalue to compare with.
VectorXd pushed_inside(const AdmissibleSet& set, const VectorXd& theta, const VectorXd& estimate) {
  constexpr double length = 1e-13;
  const bool cone =
      set.ties.empty() && std::ranges::all_of(set.inequalities, [](const auto& each) { return each.block.constant.isZero(0.0); });
  const VectorXd size = cone ? sizes_inside(set, estimate) : VectorXd(VectorXd::Ones(theta.size()));
  return theta + length * (size.cwiseProduct(set.inside) - theta);
}

AdmissibleFit untouched(const AdmissibleSet& set, const VectorXd& theta) {
  AdmissibleFit out;
  out.theta = theta;
  out.shares.assign(set.inequalities.size(), 0.0);
  out.at_limit.assign(set.inequalities.size(), 0);
  out.forces.resize(set.inequalities.size());
  return out;
}

std::vector<SymmetricBlock> blocks_of(const AdmissibleSet& set) {
  std::vector<SymmetricBlock> blocks;
  for (const Inequality& inequality : set.inequalities) blocks.push_back(inequality.block);
  return blocks;
}

/// What the blocks did to an estimate that they moved.
void take(const std::vector<SymmetricBlock>& blocks, const SemidefiniteFit& fit, const VectorXd& moved, double unit,
          bool keeps_forces, AdmissibleFit& out) {
  out.iterations = fit.iterations;
  out.converged = fit.converged;
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    VectorXd& force = out.forces[k] = VectorXd::Zero(moved.size());
    blocks[k].add_adjoint(unit * unit * fit.multiplier[k], force);
    out.shares[k] = force.dot(moved);
    if (!keeps_forces) force.resize(0);
    out.at_limit[k] = fit.at_limit[k];
  }
}

}  // namespace

AdmissibleFit nearest_admissible(const AdmissibleSet& set, const VectorXd& theta, const Eigen::MatrixXd& root, double unit) {
  const TiedLeastSquares tied = tied_least_squares(root, theta, set.offset, set.directions);
  AdmissibleFit out = untouched(set, tied.theta);
  out.null_space = tied.null_space;
  out.condition = tied.condition;
  out.tie_cost = (root * (tied.theta - theta)).squaredNorm();
  const std::vector<SymmetricBlock> blocks = blocks_of(set);
  if (!inside(blocks, tied.theta)) {
    const SemidefiniteFit fit = solve_semidefinite(blocks, tied.theta, unit * tied.basis);
    const VectorXd moved = unit * (tied.basis * fit.x);
    out.theta = pushed_inside(set, tied.theta + moved, theta);
    take(blocks, fit, moved, unit, true, out);
  }
  out.cost = (root * (out.theta - theta)).squaredNorm();
  return out;
}

std::optional<AdmissibleFit> nearest_admissible(const AdmissibleSet& set, const VectorXd& theta,
                                                const Eigen::SparseMatrix<double>& information, double unit) {
  AdmissibleFit out = untouched(set, theta);
  const std::vector<SymmetricBlock> blocks = blocks_of(set);
  if (inside(blocks, theta)) return out;
  const auto fit = solve_sparse_semidefinite(blocks, theta, information, unit);
  if (!fit || !fit->converged) return std::nullopt;
  take(blocks, *fit, fit->x - theta, unit, false, out);
  out.theta = pushed_inside(set, fit->x, theta);
  const VectorXd moved = out.theta - theta;
  out.cost = moved.dot(information.selfadjointView<Eigen::Lower>() * moved);
  return out;
}

}  // namespace jointid::ident

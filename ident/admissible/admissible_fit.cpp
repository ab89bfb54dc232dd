#include "ident/admissible/admissible_fit.hpp"

#include <algorithm>

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

/// Away from the limits by what rounding may have crossed them: a matrix that vanishes has no largest eigenvalue to compare with.
VectorXd pushed_inside(const AdmissibleSet& set, const VectorXd& theta, const VectorXd& estimate) {
  constexpr double length = 1e-13;
  const bool cone =
      set.ties.empty() && std::ranges::all_of(set.inequalities, [](const auto& each) { return each.block.constant.isZero(0.0); });
  const double size = cone ? estimate.cwiseAbs().maxCoeff() / set.inside.cwiseAbs().maxCoeff() : 1.0;
  return theta + length * (size * set.inside - theta);
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

#include "ident/admissible/sparse_semidefinite.hpp"

#include <Eigen/SparseCholesky>
#include <cmath>
#include <numeric>

#include "base/eigen.hpp"
#include "ident/admissible/interior_iteration.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;
using Factors = Eigen::SimplicialLLT<Sparse, Eigen::Lower>;
using Triplets = std::vector<Eigen::Triplet<double, int>>;

constexpr double wanted_when_sparse = 1e-14;  ///< gap over max(1, xᵀMx)

std::size_t nth(Index i) { return static_cast<std::size_t>(i); }

/// x of θ = θ̂ + Dx, D = unit/√diag N, M = D N D/unit²: of every block its own x alone.
class SparseSpace {
 public:
  SparseSpace(const std::vector<SymmetricBlock>& blocks, const VectorXd& estimate, const Sparse& information, double unit)
      : blocks_(blocks), estimate_(estimate), scale_(unit * information.diagonal().cwiseSqrt().cwiseInverse()) {
    for (Index column = 0; column < information.outerSize(); ++column) {
      for (Sparse::InnerIterator it(information, column); it; ++it) {
        if (it.row() < column) continue;
        const double value = it.value() * (scale_[it.row()] / unit) * (scale_[column] / unit);
        metric_.emplace_back(static_cast<int>(it.row()), static_cast<int>(column), value);
      }
    }
    m_.resize(estimate.size(), estimate.size());
    m_.setFromTriplets(metric_.begin(), metric_.end());
  }

  bool is_definite() const { return Factors(m_).info() == Eigen::Success; }
  const VectorXd& scale() const { return scale_; }
  const Sparse& metric() const { return m_; }

  Index unknowns() const { return estimate_.size(); }

  InteriorBlock block(std::size_t k) const {
    SymmetricBlock own = blocks_[k];
    std::iota(own.unknowns.begin(), own.unknowns.end(), Index{0});
    return {own, this->own(k, estimate_), MatrixXd(this->own(k, scale_).asDiagonal())};
  }

  VectorXd own(std::size_t k, const VectorXd& x) const {
    const std::vector<Index>& unknowns = blocks_[k].unknowns;
    VectorXd out(at(unknowns.size()));
    for (std::size_t u = 0; u < unknowns.size(); ++u) out[at(u)] = x[unknowns[u]];
    return out;
  }

  void add(std::size_t k, const VectorXd& own, VectorXd& to) const {
    for (std::size_t u = 0; u < blocks_[k].unknowns.size(); ++u) to[blocks_[k].unknowns[u]] += own[at(u)];
  }

  VectorXd gradient(const VectorXd& x) const { return m_.selfadjointView<Eigen::Lower>() * x; }

  bool factor(const std::vector<InteriorBlock>& blocks) {
    Triplets all = metric_;
    for (std::size_t k = 0; k < blocks.size(); ++k) {
      const std::vector<Index>& unknowns = blocks_[k].unknowns;
      MatrixXd curvature = MatrixXd::Zero(at(unknowns.size()), at(unknowns.size()));
      blocks[k].add_curvature(curvature);
      for (std::size_t u = 0; u < unknowns.size(); ++u) {
        for (std::size_t v = 0; v < unknowns.size(); ++v) {
          if (unknowns[u] < unknowns[v]) continue;
          all.emplace_back(static_cast<int>(unknowns[u]), static_cast<int>(unknowns[v]), curvature(at(u), at(v)));
        }
      }
    }
    Sparse matrix(unknowns(), unknowns());
    matrix.setFromTriplets(all.begin(), all.end());
    if (!analysed_) factors_.analyzePattern(matrix);
    analysed_ = true;
    factors_.factorize(matrix);
    return factors_.info() == Eigen::Success;
  }

  void solve(VectorXd& right) const { right = factors_.solve(right).eval(); }

 private:
  const std::vector<SymmetricBlock>& blocks_;
  const VectorXd& estimate_;
  VectorXd scale_;
  Triplets metric_;
  Sparse m_;
  Factors factors_;
  bool analysed_ = false;
};

/// The bounds of single unknowns that hold at their limit: per unknown its x there and the sign of its multiplier; none where
/// something else is at its limit, or all is free.
struct Held {
  std::vector<std::optional<double>> x;
  std::vector<double> sign;
};
std::optional<Held> bounds_held(const std::vector<SymmetricBlock>& blocks, const SemidefiniteFit& fit, const VectorXd& estimate,
                                const VectorXd& scale) {
  Held held{std::vector<std::optional<double>>(nth(estimate.size())), std::vector<double>(nth(estimate.size()), 0.0)};
  bool any = false;
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    if (fit.at_limit[k] == 0) continue;
    if (blocks[k].size() != 1 || blocks[k].unknowns.size() != 1) return std::nullopt;
    const Index u = blocks[k].unknowns[0];
    const double slope = blocks[k].coefficients[0][0].value;
    if (held.x[nth(u)]) return std::nullopt;
    held.x[nth(u)] = (-blocks[k].constant(0, 0) / slope - estimate[u]) / scale[u];
    held.sign[nth(u)] = slope > 0.0 ? 1.0 : -1.0;
    any = true;
  }
  return any ? std::optional(held) : std::nullopt;
}

/// min ½xᵀMx with the x that are held; empty where M of the others is not definite.
std::optional<VectorXd> with_held(const Held& held, const Sparse& m) {
  const Index n = m.cols();
  std::vector<int> number(nth(n), -1);
  int free = 0;
  for (Index i = 0; i < n; ++i) {
    if (!held.x[nth(i)]) number[nth(i)] = free++;
  }
  Triplets inner;
  VectorXd right = VectorXd::Zero(free), x = VectorXd::Zero(n);
  for (Index i = 0; i < n; ++i) x[i] = held.x[nth(i)].value_or(0.0);
  const VectorXd pull = m.selfadjointView<Eigen::Lower>() * x;
  for (Index column = 0; column < n; ++column) {
    if (number[nth(column)] < 0) continue;
    right[number[nth(column)]] = -pull[column];
    for (Sparse::InnerIterator it(m, column); it; ++it) {
      if (number[nth(it.row())] >= 0) inner.emplace_back(number[nth(it.row())], number[nth(column)], it.value());
    }
  }
  if (free == 0) return x;
  Sparse own(free, free);
  own.setFromTriplets(inner.begin(), inner.end());
  const Factors factors(own);
  if (factors.info() != Eigen::Success) return std::nullopt;
  VectorXd y = factors.solve(right);
  y += factors.solve(VectorXd(right - own.selfadjointView<Eigen::Lower>() * y));
  for (Index i = 0; i < n; ++i) {
    if (number[nth(i)] >= 0) x[i] = y[number[nth(i)]];
  }
  return x;
}

/// Whether x meets all blocks and everything that is held pulls towards its bound.
bool is_optimal(const Held& held, const VectorXd& x, const VectorXd& pull, const std::vector<SymmetricBlock>& blocks,
                const VectorXd& theta) {
  constexpr double share = 1e-9;
  for (Index i = 0; i < x.size(); ++i) {
    if (held.x[nth(i)] && held.sign[nth(i)] * pull[i] < -share * pull.cwiseAbs().maxCoeff()) return false;
  }
  return std::ranges::all_of(blocks, [&](const SymmetricBlock& block) {
    const VectorXd balanced = balance(block, theta);
    return least_eigenvalue(balanced.asDiagonal() * block.at(theta) * balanced.asDiagonal()) >= -1e-13;
  });
}

/// Puts the exact minimum with these bounds held in place of the interior point's.
void make_exact(const std::vector<SymmetricBlock>& blocks, const VectorXd& estimate, const SparseSpace& space,
                SemidefiniteFit& fit) {
  const auto held = bounds_held(blocks, fit, estimate, space.scale());
  if (!held) return;
  const auto x = with_held(*held, space.metric());
  if (!x) return;
  const VectorXd theta = estimate + space.scale().cwiseProduct(*x), pull = space.gradient(*x);
  if (!is_optimal(*held, *x, pull, blocks, theta)) return;
  fit.x = *x;
  fit.gap = 0.0;
  fit.converged = true;
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    fit.multiplier[k].setZero();
    if (fit.at_limit[k] == 0) continue;
    const Index u = blocks[k].unknowns[0];
    fit.multiplier[k](0, 0) = pull[u] / (space.scale()[u] * blocks[k].coefficients[0][0].value);
  }
}

}  // namespace

std::optional<SemidefiniteFit> solve_sparse_semidefinite(const std::vector<SymmetricBlock>& blocks, const VectorXd& estimate,
                                                         const Sparse& information, double unit) {
  if (!(VectorXd(information.diagonal()).minCoeff() > 0.0)) return std::nullopt;
  SparseSpace space(blocks, estimate, information, unit);
  if (!space.is_definite()) return std::nullopt;
  SemidefiniteFit fit = InteriorIteration<SparseSpace>(space, blocks.size(), wanted_when_sparse).run();
  make_exact(blocks, estimate, space, fit);
  fit.x = estimate + space.scale().cwiseProduct(fit.x);
  return fit;
}

}  // namespace jointid::ident

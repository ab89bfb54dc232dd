#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "ident/admissible/interior_block.hpp"
#include "ident/admissible/semidefinite_fit.hpp"

namespace jointid::ident {

/// The iteration of solve_semidefinite() for min ½ xᵀMx subject to S_k(x) ⪰ 0. `Space` has the metric and the unknowns of the
/// blocks:
///   Index unknowns() const;
///   InteriorBlock block(std::size_t k) const;                            the block over own(k, x)
///   VectorXd own(std::size_t k, const VectorXd& x) const;
///   void add(std::size_t k, const VectorXd& own, VectorXd& to) const;    its adjoint
///   VectorXd gradient(const VectorXd& x) const;                          Mx
///   bool factor(const std::vector<InteriorBlock>& blocks);               M + Σ 𝒜*(ΛS⁻¹𝒜); false where it is not definite
///   void solve(VectorXd& right) const;
template <class Space>
class InteriorIteration {
  using VectorXd = Eigen::VectorXd;

 public:
  InteriorIteration(Space& space, std::size_t blocks, double wanted)
      : space_(space), x_(VectorXd::Zero(space.unknowns())), wanted_(wanted) {
    double farthest = 1.0;  // a guess of ‖x‖: the violation in units of x
    for (std::size_t k = 0; k < blocks; ++k) {
      const InteriorBlock& own = blocks_.emplace_back(space.block(k));
      order_ += static_cast<double>(own.size());
      if (own.sensitivity() > 0.0) farthest = std::max(farthest, own.violation() / own.sensitivity());
    }
    for (InteriorBlock& block : blocks_) block.begin(farthest * farthest);
  }

  SemidefiniteFit run() {
    while (iterations_ < most_iterations && factor()) {
      if (gap() <= wanted_ * scale() + unsure() && open() <= rounding && pulled() <= 1e-9 * std::sqrt(scale())) break;
      ++iterations_;
      if (!step()) break;
    }
    SemidefiniteFit out{
        .x = x_, .value = {}, .multiplier = {}, .at_limit = {}, .gap = gap(), .iterations = iterations_, .converged = false};
    for (std::size_t k = 0; k < blocks_.size(); ++k) {
      out.value.push_back(blocks_[k].value(space_.own(k, x_)));
      out.multiplier.push_back(blocks_[k].multiplier());
      out.at_limit.push_back(blocks_[k].at_limit());
    }
    out.converged =
        out.gap <= enough * scale() + 100.0 * unsure() && open() <= most_open && pulled() <= 1e-5 * std::sqrt(scale());
    return out;
  }

 private:
  static constexpr std::size_t most_iterations = 100;
  static constexpr double enough = 1e-8;     ///< gap over max(1, ‖x‖²)
  static constexpr double rounding = 1e-13;  ///< of S, whose elements are near 1
  /// What S(x) may lie beside S at the end: near a singular S, steps end before all of it is made good.
  static constexpr double most_open = 5e-11;

  double scale() const { return std::max(1.0, x_.dot(space_.gradient(x_))); }

  double gap() const {
    double sum = 0.0;
    for (const InteriorBlock& block : blocks_) sum += block.gap();
    return sum;
  }

  double unsure() const {
    double sum = 0.0;
    for (const InteriorBlock& block : blocks_) sum += block.rounding();
    return sum;
  }

  /// What is open of S(x) = S and of Mx = Σ 𝒜*(Λ).
  double open() const {
    double most = 0.0;
    for (const InteriorBlock& block : blocks_) most = std::max(most, block.missing());
    return most;
  }
  double pulled() const {
    VectorXd rest = space_.gradient(x_);
    for (std::size_t k = 0; k < blocks_.size(); ++k) space_.add(k, -blocks_[k].force(), rest);
    return rest.norm();
  }

  bool factor() {
    for (std::size_t k = 0; k < blocks_.size(); ++k) {
      if (!blocks_[k].factor(space_.own(k, x_))) return false;
    }
    return true;
  }

  VectorXd direct(double sigma_mu, bool second_order) {
    VectorXd right = -space_.gradient(x_);
    for (std::size_t k = 0; k < blocks_.size(); ++k) space_.add(k, blocks_[k].pull(sigma_mu, second_order), right);
    space_.solve(right);
    const VectorXd& dx = right;
    for (std::size_t k = 0; k < blocks_.size(); ++k) blocks_[k].direct(space_.own(k, dx), sigma_mu, second_order);
    return dx;
  }

  double room() const {
    double least = 1.0 / 0.95;
    for (const InteriorBlock& block : blocks_) least = std::min(least, block.room());
    return least;
  }

  /// Mehrotra's predictor and corrector; false when there is no way on.
  bool step() {
    if (!space_.factor(blocks_)) return false;
    const double mu = gap() / order_;
    direct(0.0, false);
    const double reach = std::min(1.0, room());
    double ahead = 0.0;
    for (const InteriorBlock& block : blocks_) ahead += block.gap_after(reach);
    const double sigma = std::clamp(std::pow(ahead / (order_ * mu), 3.0), 1e-6, 1.0);
    const VectorXd dx = direct(sigma * mu, true);
    const double length = std::min(1.0, 0.95 * room());
    if (!dx.allFinite() || length < 1e-10) return false;
    x_ += length * dx;
    for (InteriorBlock& block : blocks_) block.advance(length);
    return true;
  }

  Space& space_;
  VectorXd x_;
  double wanted_;
  std::vector<InteriorBlock> blocks_;
  double order_ = 0.0;
  std::size_t iterations_ = 0;
};

}  // namespace jointid::ident

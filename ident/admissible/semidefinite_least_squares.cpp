#include "ident/admissible/semidefinite_least_squares.hpp"

#include <algorithm>
#include <cmath>

#include "dense/cholesky.hpp"
#include "ident/admissible/interior_block.hpp"

namespace jointid::ident {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t most_iterations = 100;
constexpr double wanted = 1e-12, enough = 1e-8;  ///< gap over max(1, ‖x‖²)
constexpr double rounding = 1e-13;               ///< of S, whose elements are near 1
/// What S(x) may lie beside S at the end: near a singular S, steps end before all of it is made good.
constexpr double most_open = 5e-11;

class InteriorPoint {
 public:
  InteriorPoint(const std::vector<SymmetricBlock>& blocks, const VectorXd& origin, const MatrixXd& basis)
      : x_(VectorXd::Zero(basis.cols())) {
    double farthest = 1.0;  // a guess of ‖x‖: the violation in units of x
    for (const SymmetricBlock& block : blocks) {
      const InteriorBlock& own = blocks_.emplace_back(block, origin, basis);
      order_ += static_cast<double>(block.size());
      if (own.sensitivity() > 0.0) farthest = std::max(farthest, own.violation() / own.sensitivity());
    }
    for (InteriorBlock& block : blocks_) block.begin(farthest * farthest);
  }

  SemidefiniteFit run() {
    while (iterations_ < most_iterations && factor()) {
      if (gap() <= wanted * scale() + unsure() && open() <= rounding && pulled() <= 1e-9 * std::sqrt(scale())) break;
      ++iterations_;
      if (!step()) break;
    }
    SemidefiniteFit out{
        .x = x_, .value = {}, .multiplier = {}, .at_limit = {}, .gap = gap(), .iterations = iterations_, .converged = false};
    for (const InteriorBlock& block : blocks_) {
      out.value.push_back(block.value(x_));
      out.multiplier.push_back(block.multiplier());
      out.at_limit.push_back(block.at_limit());
    }
    out.converged = out.gap <= enough * scale() + 100.0 * unsure() && open() <= most_open && pulled() <= 1e-5 * std::sqrt(scale());
    return out;
  }

 private:
  double scale() const { return std::max(1.0, x_.squaredNorm()); }

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

  /// What is open of S(x) = S and of x = Σ 𝒜*(Λ).
  double open() const {
    double most = 0.0;
    for (const InteriorBlock& block : blocks_) most = std::max(most, block.missing());
    return most;
  }
  double pulled() const {
    VectorXd rest = x_;
    for (const InteriorBlock& block : blocks_) rest -= block.force();
    return rest.norm();
  }

  bool factor() {
    for (InteriorBlock& block : blocks_) {
      if (!block.factor(x_)) return false;
    }
    return true;
  }

  VectorXd direct(const MatrixXd& root, double sigma_mu, bool second_order) {
    VectorXd right = -x_;
    for (const InteriorBlock& block : blocks_) right += block.pull(sigma_mu, second_order);
    dense::solve_lower(root, right);
    dense::solve_lower_transposed(root, right);
    const VectorXd& dx = right;
    for (InteriorBlock& block : blocks_) block.direct(dx, sigma_mu, second_order);
    return dx;
  }

  double room() const {
    double least = 1.0 / 0.95;
    for (const InteriorBlock& block : blocks_) least = std::min(least, block.room());
    return least;
  }

  /// Mehrotra's predictor and corrector; false when there is no way on.
  bool step() {
    MatrixXd matrix = MatrixXd::Identity(x_.size(), x_.size());
    for (const InteriorBlock& block : blocks_) block.add_curvature(matrix);
    if (!dense::cholesky_in_place(matrix)) return false;
    const double mu = gap() / order_;
    direct(matrix, 0.0, false);
    const double reach = std::min(1.0, room());
    double ahead = 0.0;
    for (const InteriorBlock& block : blocks_) ahead += block.gap_after(reach);
    const double sigma = std::clamp(std::pow(ahead / (order_ * mu), 3.0), 1e-6, 1.0);
    const VectorXd dx = direct(matrix, sigma * mu, true);
    const double length = std::min(1.0, 0.95 * room());
    if (!dx.allFinite() || length < 1e-10) return false;
    x_ += length * dx;
    for (InteriorBlock& block : blocks_) block.advance(length);
    return true;
  }

  VectorXd x_;
  std::vector<InteriorBlock> blocks_;
  double order_ = 0.0;
  std::size_t iterations_ = 0;
};

}  // namespace

SemidefiniteFit solve_semidefinite(const std::vector<SymmetricBlock>& blocks, const VectorXd& origin, const MatrixXd& basis) {
  return InteriorPoint(blocks, origin, basis).run();
}

}  // namespace jointid::ident

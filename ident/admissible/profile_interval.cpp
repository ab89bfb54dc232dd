#include "ident/admissible/profile_interval.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ident/admissible/semidefinite_least_squares.hpp"
#include "ident/admissible/tied_least_squares.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double profile_quantile = 1.959963984540054;

/// The nearest points of the set to θ̂ + τ·C e_i, in coordinates in which χ² is ‖x‖².
class Profile {
 public:
  Profile(const AdmissibleSet& set, const VectorXd& estimate, const Eigen::MatrixXd& root)
      : estimate_(estimate), tied_(tied_least_squares(root, estimate, set.offset, set.directions)) {
    for (const Inequality& inequality : set.inequalities) blocks_.push_back(inequality.block);
    least_ = at(VectorXd::Zero(tied_.basis.cols()));
  }

  struct Point {
    VectorXd theta;
    double chi_square = 0.0;
  };

  std::array<double, 2> interval(Index unknown) const {
    const VectorXd way = tied_.basis.row(unknown).transpose();
    const double deviation = way.norm();
    if (!(deviation > 0.0)) return {least_.theta[unknown], least_.theta[unknown]};
    return {at_bound(unknown, end(unknown, -way / deviation, deviation), deviation),
            at_bound(unknown, end(unknown, way / deviation, deviation), deviation)};
  }

 private:
  /// The bound of the unknown itself where an end is there, which the interior point comes near to only.
  double at_bound(Index unknown, double end, double deviation) const {
    constexpr double there = 1e-3;
    for (const SymmetricBlock& block : blocks_) {
      if (block.size() != 1 || block.unknowns.size() != 1 || block.unknowns[0] != unknown) continue;
      const double bound = -block.constant(0, 0) / block.coefficients[0][0].value;
      if (std::abs(end - bound) <= there * deviation) return bound;
    }
    return end;
  }

  /// Nearest to θ̂ + basis·shift.
  Point at(const VectorXd& shift) const {
    const VectorXd from = estimate_ + tied_.basis * shift;
    const bool is_inside =
        std::ranges::all_of(blocks_, [&](const SymmetricBlock& block) { return least_eigenvalue(block.at(from)) >= 0.0; });
    if (is_inside) return {from, shift.squaredNorm()};
    const VectorXd moved = shift + solve_semidefinite(blocks_, from, tied_.basis).x;
    return {estimate_ + tied_.basis * moved, moved.squaredNorm()};
  }

  /// θ_i where χ² has risen by the square of the profile_quantile, along a unit vector; or where it goes no further.
  double end(Index unknown, const VectorXd& way, double deviation) const {
    constexpr int most = 30;
    constexpr double near = 1e-3, still = 1e-5;
    const auto excess = [&](const Point& point) {
      return std::sqrt(std::max(0.0, point.chi_square - least_.chi_square)) - profile_quantile;
    };
    const double released =
        4.0 * (std::sqrt(least_.chi_square) + profile_quantile);  // what is at its limit leaves it before, if ever
    double low = 0.0, below = -profile_quantile, high = profile_quantile;
    Point point = at(high * way);
    double above = excess(point), last = least_.theta[unknown];
    for (int k = 0; k < most && above < 0.0; ++k) {
      if (high > released && std::abs(point.theta[unknown] - last) < still * deviation) return point.theta[unknown];
      last = point.theta[unknown];
      low = std::exchange(high, 2.0 * high);
      below = above;
      point = at(high * way);
      above = excess(point);
    }
    double at_end = point.theta[unknown];
    for (int k = 0; k < most && std::abs(excess(point)) > near; ++k) {  // regula falsi, halved where it stays on one side
      const double middle = k % 3 == 2 ? 0.5 * (low + high) : low + (high - low) * below / (below - above);
      point = at(middle * way);
      at_end = point.theta[unknown];
      (excess(point) < 0.0 ? low : high) = middle;
      (excess(point) < 0.0 ? below : above) = excess(point);
    }
    return at_end;
  }

  VectorXd estimate_;
  TiedLeastSquares tied_;
  std::vector<SymmetricBlock> blocks_;
  Point least_;
};

double normal_below(double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); }

}  // namespace

std::vector<std::array<double, 2>> profile_intervals(const AdmissibleSet& set, const VectorXd& estimate,
                                                     const Eigen::MatrixXd& root) {
  const Profile profile(set, estimate, root);
  std::vector<std::array<double, 2>> out;
  for (Index unknown = 0; unknown < estimate.size(); ++unknown) out.push_back(profile.interval(unknown));
  return out;
}

std::array<double, 2> densest_interval(double centre, double deviation, double lower, double upper) {
  const double first = normal_below((lower - centre) / deviation), last = normal_below((upper - centre) / deviation);
  if (!(last - first > 1e-12)) return {std::clamp(centre, lower, upper), std::clamp(centre, lower, upper)};
  // Its ends are as far from the centre as the limits let them: half-width w, cut.
  double narrow = 0.0, wide = 40.0;
  for (int k = 0; k < 60; ++k) {
    const double w = 0.5 * (narrow + wide);
    const double from = std::max(lower, centre - w * deviation), to = std::min(upper, centre + w * deviation);
    const double inside = to > from ? normal_below((to - centre) / deviation) - normal_below((from - centre) / deviation) : 0.0;
    (inside < 0.95 * (last - first) ? narrow : wide) = w;
  }
  return {std::clamp(centre - wide * deviation, lower, upper), std::clamp(centre + wide * deviation, lower, upper)};
}

}  // namespace jointid::ident

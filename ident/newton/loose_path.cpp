#include "ident/newton/loose_path.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "base/error.hpp"
#include "dense/cholesky.hpp"
#include "dense/eigen.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// min ½ dᵀHd + gᵀd + λ Σ d over 0 ≤ x + d ≤ most_lost of some coordinates, one coordinate after the other: x + d.
VectorXd bounded_step(const MatrixXd& h, const VectorXd& g, double penalty, const VectorXd& x, const std::vector<Index>& free) {
  constexpr int most = 5000;
  constexpr double settled = 1e-10;
  VectorXd out = x, slope = g;
  slope.array() += penalty;
  for (int turn = 0; turn < most; ++turn) {
    double largest = 0.0;
    for (const Index j : free) {
      if (!(h(j, j) > 0.0)) continue;
      const double next = std::clamp(out[j] - slope[j] / h(j, j), 0.0, most_lost), change = next - out[j];
      if (change == 0.0) continue;
      slope += change * h.col(j);
      out[j] = next;
      largest = std::max(largest, std::abs(change));
    }
    if (largest < settled) break;
  }
  return out;
}

/// A point of the path with what belongs to it.
struct PathPoint {
  VectorXd lost, residual;  ///< ln f over that measured
  MatrixXd by_lost;         ///< of the residual

  double squares() const { return residual.squaredNorm(); }
  double cost(double penalty) const { return 0.5 * squares() + penalty * lost.sum(); }
};

class LoosePath {
 public:
  LoosePath(const SharedStiffness& structure, const std::vector<double>& frequency_hz, const std::function<void()>& watch)
      : structure_(structure), watch_(watch), measured_(at(frequency_hz.size())) {
    for (std::size_t r = 0; r < frequency_hz.size(); ++r) measured_[at(r)] = 2.0 * std::log(angular(frequency_hz[r]));
    for (Index j = 0; j < joints(); ++j) all_.push_back(j);
  }

  LooseFit run() {
    constexpr int most = 60, without_gain = 6;
    PathPoint now = point(VectorXd::Zero(joints()));
    const double sound = std::sqrt(now.squares() / static_cast<double>(measured_.size()));
    keep(now, {});
    double penalty = std::max(0.0, (-now.by_lost.transpose() * now.residual).maxCoeff());
    std::set<std::vector<Index>> tried = {{}};
    for (int step = 0, idle = 0; step < most && idle < without_gain && penalty > 0.0; ++step, ++idle) {
      penalty *= 0.5;
      now = fitted(std::move(now), penalty, all_);
      std::vector<Index> loose = loose_of(now.lost);
      if (2 * at(loose.size()) >= measured_.size()) break;
      if (!tried.insert(loose).second) continue;
      if (keep(fitted(now, 0.0, loose), loose)) idle = 0;
    }
    best_.before = sound;
    best_.solutions = solutions_;
    return best_;
  }

 private:
  Index joints() const { return at(structure_.joints()); }

  PathPoint point(VectorXd lost) {
    watch_();
    ++solutions_;
    const ElasticModes modes = elastic_modes(structure_, lost, measured_.size());
    return {std::move(lost), 0.5 * (modes.logarithm - measured_), 0.5 * modes.by_lost};
  }

  static std::vector<Index> loose_of(const VectorXd& lost) {
    constexpr double least = 1e-3;
    std::vector<Index> out;
    for (Index j = 0; j < lost.size(); ++j) {
      if (lost[j] > least) out.push_back(j);
    }
    return out;
  }

  /// Gauss–Newton steps with the bounds, shortened until the cost falls; joints that are not `free` are sound.
  PathPoint fitted(PathPoint now, double penalty, const std::vector<Index>& free) {
    constexpr int most = 20, shortest = 10;
    constexpr double ridge = 1e-9, settled = 1e-6;
    if (at(free.size()) < joints()) now = point(only(now.lost, free));
    for (int i = 0; i < most; ++i) {
      MatrixXd h = now.by_lost.transpose() * now.by_lost;
      h.diagonal() *= 1.0 + ridge;
      const VectorXd change = bounded_step(h, now.by_lost.transpose() * now.residual, penalty, now.lost, free) - now.lost;
      if (change.cwiseAbs().maxCoeff() < settled) break;
      double length = 1.0;
      PathPoint next = point(now.lost + change);
      for (int k = 0; k < shortest && !(next.cost(penalty) < now.cost(penalty)); ++k) next = point(now.lost + (length *= 0.5) * change);
      if (!(next.cost(penalty) < now.cost(penalty))) break;
      now = std::move(next);
    }
    return now;
  }

  static VectorXd only(const VectorXd& lost, const std::vector<Index>& free) {
    VectorXd out = VectorXd::Zero(lost.size());
    for (const Index j : free) out[j] = lost[j];
    return out;
  }

  /// Whether a set of loose joints explains the frequencies better than those before; then it is what remains.
  bool keep(const PathPoint& at_set, const std::vector<Index>& loose) {
    constexpr double exact = 1e-20;  // square of a relative frequency: below is rounding
    const auto n = static_cast<double>(measured_.size()), k = static_cast<double>(loose.size()), p = static_cast<double>(joints());
    const double criterion = n * std::log(at_set.squares() / n + exact) + k * (std::log(n) + 2.0 * std::log(p));
    if (!loose.empty() && criterion >= criterion_) return false;
    criterion_ = criterion;
    const double variance = at_set.squares() / std::max(1.0, n - k);
    best_.lost = only(at_set.lost, loose);
    best_.misfit = std::sqrt(variance);
    best_.std_error = VectorXd::Zero(joints());
    if (loose.empty()) return true;
    const MatrixXd own = at_set.by_lost(Eigen::all, loose);
    const MatrixXd covariance = dense::solve_positive(MatrixXd(own.transpose() * own), MatrixXd::Identity(own.cols(), own.cols()));
    for (std::size_t j = 0; j < loose.size(); ++j) best_.std_error[loose[j]] = std::sqrt(variance * std::abs(covariance(at(j), at(j))));
    return true;
  }

  const SharedStiffness& structure_;
  const std::function<void()>& watch_;
  VectorXd measured_;  ///< ln ω²
  std::vector<Index> all_;
  std::size_t solutions_ = 0;
  double criterion_ = 0.0;
  LooseFit best_;
};

}  // namespace

ElasticModes elastic_modes(const SharedStiffness& of, const VectorXd& lost, Index count) {
  constexpr double rounding = 1e-15;
  MatrixXd k = of.stiffness;
  for (std::size_t j = 0; j < of.joints(); ++j) {
    for (const auto& [row, column, value] : of.of_joint[j]) k(row, column) += (1.0 - lost[at(j)]) * value;
  }
  const dense::SymmetricEigen eigen = dense::symmetric_eigen(k, of.mass);
  if (!eigen.values.allFinite())
    refuse("the mass matrix of the parts is not positive definite", "give every coordinate of the models a mass");
  const double rigid = rounding * static_cast<double>(eigen.values.size()) * eigen.values.cwiseAbs().maxCoeff();
  Index first = 0;
  while (first < eigen.values.size() && !(eigen.values[first] > rigid)) ++first;
  if (first + count > eigen.values.size()) {
    refuse("the structure has " + std::to_string(eigen.values.size() - first) + " elastic modes, and " + std::to_string(count) +
           " frequencies are given",
           "leave the highest out");
  }
  ElasticModes out{eigen.values.segment(first, count).array().log(), MatrixXd::Zero(count, at(of.joints()))};
  for (Index r = 0; r < count; ++r) {
    const auto shape = eigen.vectors.col(first + r);
    for (std::size_t j = 0; j < of.joints(); ++j) {
      double energy = 0.0;
      for (const auto& [row, column, value] : of.of_joint[j]) energy += shape[row] * value * shape[column];
      out.by_lost(r, at(j)) = -energy / eigen.values[first + r];
    }
  }
  return out;
}

LooseFit fit_loose_joints(const SharedStiffness& structure, const std::vector<double>& frequency_hz, const std::function<void()>& watch) {
  return LoosePath(structure, frequency_hz, watch).run();
}

}  // namespace jointid::ident

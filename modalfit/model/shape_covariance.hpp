#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <vector>

namespace jointid::modalfit {

/// Coordinates in two groups: the core, at least one of which every measured FRF has, and the rest, which no FRF joins. The core are
/// the references or the responses, whichever are fewer.
struct Core {
  std::vector<std::size_t> place;  ///< [n] index in the core, or count + index in the rest
  std::size_t count = 0;           ///< of the core

  Core() = default;
  explicit Core(const std::vector<bool>& is_core);

  std::size_t size() const { return place.size(); }
  std::size_t rest() const { return place.size() - count; }
  bool has(std::size_t coordinate) const { return place[coordinate] < count; }
};

/// E δφ δφᴴ of a mode shape over n coordinates, k of them in the core: δφ_rest = T δφ_core + independent errors. Memory n·k.
class ShapeCovariance {
 public:
  ShapeCovariance() = default;
  /// `with_core` [n,k] E δφ_i δφ_c*, rows by place; `slope` T [n−k,k]; `own` [n−k] variances of the independent errors.
  ShapeCovariance(Core core, Eigen::MatrixXcd with_core, Eigen::MatrixXcd slope, Eigen::VectorXd own);

  std::complex<double> between(std::size_t a, std::size_t b) const;
  double variance(std::size_t a) const { return between(a, a).real(); }
  /// Numbers kept: n·k, k(n−k) and n−k.
  std::size_t size() const { return static_cast<std::size_t>(with_core_.size() + slope_.size() + own_.size()); }
  /// Of a shape times √factor.
  void multiply(double factor);

 private:
  Core core_;
  Eigen::MatrixXcd with_core_, slope_;
  Eigen::VectorXd own_;
};

}  // namespace jointid::modalfit

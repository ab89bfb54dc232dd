#include "ident/likelihood/fit/godambe_information.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "dense/cholesky.hpp"
#include "dense/eigen.hpp"
#include "minimise/linear/covariance.hpp"

namespace jointid::ident {
namespace {

constexpr double way = 0.3;        // standard deviations to either side
constexpr double noticed = 0.02;   // a relative difference that is worth knowing
constexpr double least_curvature = 0.1, most_curvature = 3.0;  // of the information's curvature: else differences tell none

}  // namespace

Eigen::MatrixXd godambe_information(const GradientAt& gradient, const Eigen::MatrixXd& information, const GradientAt& quick) {
  if (minimise::null_space_of(information).cols() > 0) return information;
  const auto root = dense::cholesky(minimise::covariance_of(information));
  if (!root) return information;
  const Eigen::MatrixXd& unit = *root;  // offsets of one standard deviation: the information is the identity there
  const auto by_differences = [&unit](const GradientAt& of) {
    return [&unit, &of](const Eigen::VectorXd& direction) {
      const Eigen::VectorXd offset = unit * (way * direction);
      return Eigen::VectorXd(unit.transpose() * (of(-offset) - of(offset)) / (2.0 * way));
    };
  };
  const auto along = by_differences(gradient);
  const Eigen::Index size = information.rows();
  std::mt19937_64 random(static_cast<std::uint64_t>(size));
  std::vector<Eigen::VectorXd> probes(3, Eigen::VectorXd(size));
  for (Eigen::VectorXd& direction : probes) {
    for (double& value : direction) value = (random() & 1u) != 0 ? 1.0 : -1.0;
    direction /= std::sqrt(static_cast<double>(size));
  }
  const auto differs = [&probes](double least, const auto& difference) {
    return std::ranges::any_of(
        probes, [&](const Eigen::VectorXd& probe) { return !(std::abs(probe.dot(difference(probe)) - 1.0) < least); });
  };
  if (quick) {
    const Eigen::VectorXd here = quick(Eigen::VectorXd::Zero(size));
    const auto to_one_side = [&](const Eigen::VectorXd& direction) {
      return Eigen::VectorXd(unit.transpose() * (here - quick(unit * (way * direction))) / way);
    };
    if (!differs(0.25 * noticed, to_one_side)) return information;
  }
  if (!differs(noticed, by_differences(quick ? quick : gradient))) return information;
  Eigen::MatrixXd curvature(size, size);
  for (Eigen::Index c = 0; c < size; ++c) curvature.col(c) = along(Eigen::VectorXd::Unit(size, c));
  if (!curvature.allFinite()) return information;
  curvature = 0.5 * (curvature + curvature.transpose()).eval();
  const Eigen::VectorXd values = dense::symmetric_eigenvalues(curvature);
  if (!(values[0] > least_curvature && values[size - 1] < most_curvature)) return information;
  Eigen::MatrixXd half = Eigen::MatrixXd::Identity(size, size);
  dense::solve_lower(unit, half);  // unit⁻¹
  return half.transpose() * (curvature * curvature) * half;
}

}  // namespace jointid::ident

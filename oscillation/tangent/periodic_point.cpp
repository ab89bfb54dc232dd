#include "oscillation/tangent/periodic_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dense/eigen.hpp"
#include "dense/minimum_norm.hpp"

namespace jointid::oscillation {
namespace {

struct Image {
  Eigen::VectorXd residual;
  Eigen::MatrixXd derivative;
  double size() const { return residual.allFinite() ? residual.cwiseAbs().maxCoeff() : std::numeric_limits<double>::infinity(); }
};

Image image(const TangentStep& step, const Eigen::VectorXd& z, std::size_t times) {
  Eigen::VectorXd state = z;
  Eigen::MatrixXd tangents = Eigen::MatrixXd::Identity(z.size(), z.size());
  for (std::size_t k = 0; k < times; ++k) step(state, tangents);
  return {state - z, std::move(tangents)};
}

std::vector<Complex> ordered(const Eigen::VectorXcd& values) {
  std::vector<Complex> out(values.begin(), values.end());
  std::ranges::stable_sort(out, [](const Complex& a, const Complex& b) { return std::abs(a) > std::abs(b); });
  return out;
}

}  // namespace

PeriodicPoint periodic_point(const TangentStep& step, const Eigen::VectorXd& start, std::size_t times,
                             std::size_t most_iterations) {
  PeriodicPoint out;
  out.state = start;
  Image here = image(step, out.state, times);
  const auto scale = [&] { return 1.0 + out.state.cwiseAbs().maxCoeff(); };
  for (; out.iterations < most_iterations && here.size() > 1e-14 * scale(); ++out.iterations) {
    if (!here.derivative.allFinite() || !std::isfinite(here.size())) break;
    const Eigen::MatrixXd slope = here.derivative - Eigen::MatrixXd::Identity(start.size(), start.size());
    const Eigen::VectorXd change = -dense::RealMinimumNorm(slope, 1e-12).solve(here.residual);
    double share = 1.0;
    Image next;
    for (; share > 1e-4; share *= 0.5) {
      next = image(step, out.state + share * change, times);
      if (next.size() < here.size()) break;
    }
    if (share <= 1e-4) break;
    out.state += share * change;
    here = std::move(next);
  }
  out.residual = here.size();
  out.converged = out.residual <= 1e-9 * scale();
  if (here.derivative.allFinite()) out.multipliers = ordered(dense::eigenvalues(here.derivative));
  return out;
}

}  // namespace jointid::oscillation

#include "ident/likelihood/bundle/bundle_functions.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"

namespace jointid::ident {

std::vector<double> JointScale::theta(const double* t) const {
  std::vector<double> out = centre;
  for (std::size_t i = 0; i < out.size(); ++i) out[i] += scale[i] * t[i];
  return out;
}

bool LineCost::evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
  const std::vector<double> theta = joint_.theta(parameters[0]);
  RowMatrixXd by_theta, by_own;
  double* to_theta = jacobians ? jacobians[0] : nullptr;
  double* to_own = jacobians ? jacobians[1] : nullptr;
  line_.evaluate(theta, parameters[1], residuals, to_theta ? &by_theta : nullptr, to_own ? &by_own : nullptr);
  if (to_theta) {
    const Eigen::Map<const Eigen::VectorXd> scale(joint_.scale.data(), at(joint_.scale.size()));
    by_theta *= scale.asDiagonal();
    std::copy_n(by_theta.data(), by_theta.size(), to_theta);
  }
  if (to_own) std::copy_n(by_own.data(), by_own.size(), to_own);
  return std::all_of(residuals, residuals + line_.residuals(), [](double r) { return std::isfinite(r); });
}

void LineLoss::evaluate(double s, double rho[3]) const {
  const double share = s <= limit_ ? 1.0 : limit_ / s;
  rho[0] = s <= limit_ ? s : limit_ * (2.0 - share);
  rho[1] = share * share;
  rho[2] = s <= limit_ ? 0.0 : -2.0 * share * share / s;
}

}  // namespace jointid::ident

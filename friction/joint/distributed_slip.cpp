#include "friction/joint/distributed_slip.hpp"

#include <algorithm>
#include <cmath>

namespace jointid::friction {

DistributedSlip::DistributedSlip(Sliders sliders) : sliders_(std::move(sliders)), force_(sliders_.slip.size(), 0.0) {}

Response DistributedSlip::advance(double u, double load) {
  const double step = u - displacement_;
  Response total = {sliders_.rest * u, sliders_.rest};
  for (std::size_t i = 0; i < force_.size(); ++i) {
    const double stiffness = sliders_.stiffness[i], limit = std::max(load, 0.0) * stiffness * sliders_.slip[i];
    const double elastic = force_[i] + stiffness * step;
    force_[i] = std::clamp(elastic, -limit, limit);
    loss_ += std::abs(force_[i]) * std::abs(elastic - force_[i]) / stiffness;
    total.force += force_[i];
    if (std::abs(elastic) < limit) total.tangent += stiffness;
  }
  displacement_ = u;
  return total;
}

Response DistributedSlip::response(double u, double load) const {
  const double step = u - displacement_;
  Response total = {sliders_.rest * u, sliders_.rest};
  for (std::size_t i = 0; i < force_.size(); ++i) {
    const double stiffness = sliders_.stiffness[i], limit = std::max(load, 0.0) * stiffness * sliders_.slip[i];
    const double elastic = force_[i] + stiffness * step;
    total.force += std::clamp(elastic, -limit, limit);
    if (std::abs(elastic) < limit) total.tangent += stiffness;
  }
  return total;
}

double DistributedSlip::stored() const {
  double energy = 0.5 * sliders_.rest * displacement_ * displacement_;
  for (std::size_t i = 0; i < force_.size(); ++i) energy += 0.5 * force_[i] * force_[i] / sliders_.stiffness[i];
  return energy;
}

}  // namespace jointid::friction

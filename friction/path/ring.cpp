#include "friction/path/ring.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "friction/path/quadrature.hpp"

namespace jointid::friction {
namespace {

constexpr double pi = std::numbers::pi;

/// Unit of a parameter whose law gives N/m² instead of N.
std::string per_area(const std::string& unit) {
  if (unit == "N") return "N/m^2";
  if (unit == "N/m") return "N/m^3";
  if (unit == "N/m^2") return "N/m^4";
  return unit;
}

}  // namespace

Ring::Ring(std::shared_ptr<const Element> law, double inner, double outer)
    : law_(std::move(law)), inner_(inner), outer_(outer) {
  if (!(inner >= 0.0 && outer > inner && std::isfinite(outer))) {
    refuse("ring: radii " + std::to_string(inner) + ", " + std::to_string(outer) +
                                " must be finite with 0 <= inner < outer");
  }
}

/// dM/dθ = ∫2πr³τ′ dr = (2π[r³τ] − 3M)/θ by parts.
Response Ring::response(double angle) const {
  const double outer3 = outer_ * outer_ * outer_, inner3 = inner_ * inner_ * inner_;
  if (angle < 1e-60) {  // fourth powers of it would be zero
    const double stiffness = 0.5 * pi * (outer3 * outer_ - inner3 * inner_) * law_->response(0.0).tangent;
    return {stiffness * angle, stiffness};
  }
  const Response out = law_->response(outer_ * angle), in = law_->response(inner_ * angle);
  if (inner_ > 0.0 && in.tangent == 0.0) return {limit(), 0.0};
  const double moment = law_->second_moment(outer_ * angle) - law_->second_moment(inner_ * angle);
  const double torque = 2.0 * pi * moment / (angle * angle * angle);
  const double tangent = (2.0 * pi * (outer3 * out.force - inner3 * in.force) - 3.0 * torque) / angle;
  return {torque, std::max(tangent, 0.0)};
}

/// ∫2πr Φ(rθ) dr with Φ = ∫τ du, by parts.
double Ring::energy(double angle) const {
  return pi * (outer_ * outer_ * law_->energy(outer_ * angle) - inner_ * inner_ * law_->energy(inner_ * angle)) -
         0.5 * angle * response(angle).force;
}

double Ring::limit() const {
  return 2.0 / 3.0 * pi * (outer_ * outer_ * outer_ - inner_ * inner_ * inner_) * law_->limit();
}

std::vector<double> Ring::kinks() const {
  std::vector<double> all;
  for (const double kink : law_->kinks()) {
    all.push_back(kink / outer_);
    if (inner_ > 0.0) all.push_back(kink / inner_);
  }
  std::ranges::sort(all);
  return all;
}

std::vector<Parameter> Ring::parameters() const {
  std::vector<Parameter> result = law_->parameters();
  for (Parameter& parameter : result) parameter.unit = per_area(parameter.unit);
  return result;
}

std::vector<double> Ring::rings(double angle) const {
  std::vector<double> radii = {inner_};
  for (const double kink : law_->kinks()) {
    if (kink > inner_ * angle && kink < outer_ * angle) radii.push_back(kink / angle);
  }
  radii.push_back(outer_);
  return radii;
}

void Ring::derivative(double angle, std::span<double> out) const {
  std::vector<double> in(out.size());
  law_->second_moment_derivative(outer_ * angle, out);
  law_->second_moment_derivative(inner_ * angle, in);
  const double scale = angle < 1e-60 ? 0.0 : 2.0 * pi / (angle * angle * angle);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = scale * (out[i] - in[i]);
}

std::unique_ptr<Element> Ring::with(std::span<const double> values) const {
  return std::make_unique<Ring>(law_->with(values), inner_, outer_);
}

double Ring::cycle_energy(double angle) const {
  return integrate([&](double r) { return 2.0 * pi * r * law_->cycle_energy(r * angle); }, rings(angle));
}

}  // namespace jointid::friction

#include "friction/law/shoukry.hpp"

#include <array>
#include <cmath>

#include "friction/path/cancellation_free.hpp"

namespace jointid::friction {
namespace {

constexpr std::array shoukry_parameters = {LawParameter{"a", "N", 0.0, infinity}, LawParameter{"b", "1/m", 0.0, infinity}};
constexpr std::array shoukry_shapes = {0.0};

std::vector<double> shoukry_start(const Features& f, double) { return {f.limit, f.stiffness / f.limit}; }

}  // namespace

const Law Shoukry::law = {"shoukry", "exponential (Shoukry, Rogers)", shoukry_parameters, {shoukry_shapes, shoukry_start}};

Shoukry::Shoukry(std::span<const double> values) : ListedLaw(values) {
  limit_ = values[0];
  rate_ = values[1];
}

Response Shoukry::response(double u) const {
  return {-limit_ * std::expm1(-rate_ * u), limit_ * rate_ * std::exp(-rate_ * u)};
}

double Shoukry::energy(double u) const { return limit_ / rate_ * linear_minus_exponential(rate_ * u); }

double Shoukry::displacement(double force) const {
  return force < limit_ ? -std::log1p(-force / limit_) / rate_ : infinity;
}

void Shoukry::derivative(double u, std::span<double> out) const {
  out[0] = -std::expm1(-rate_ * u);
  out[1] = limit_ * u * std::exp(-rate_ * u);
}

/// 4a[u(1 + e^{−r}) − 2(1 − e^{−r})/b] with r = bu, written without differences.
double Shoukry::cycle_energy(double u) const {
  return 16.0 * limit_ / rate_ * damped_hyperbolic_excess(0.5 * rate_ * u);
}

/// (4a/u) e^{−r/2} I₁(r/2).
double Shoukry::equivalent_stiffness(double u) const { return 4.0 * limit_ / u * scaled_bessel_i1(0.5 * rate_ * u); }

double Shoukry::second_moment(double u) const {
  return limit_ / (rate_ * rate_ * rate_) * exponential_second_moment(rate_ * u);
}

void Shoukry::second_moment_derivative(double u, std::span<double> out) const {
  const double x = rate_ * u, moment = exponential_second_moment(x), rate3 = rate_ * rate_ * rate_;
  out[0] = moment / rate3;
  out[1] = limit_ / (rate3 * rate_) * (-x * x * x * std::expm1(-x) - 3.0 * moment);
}

}  // namespace jointid::friction

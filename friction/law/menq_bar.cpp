#include "friction/law/menq_bar.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "base/error.hpp"

namespace jointid::friction {
namespace {

template <class Number>
struct State {
  Number force, displacement;
};

/// K(ℓ) of values {EA, L, k, τ, β}.
template <class Number>
Number sticking_stiffness(const std::array<Number, 5>& p, const Number& length) {
  const Number kappa = std::sqrt(p[2] * p[0]), t = std::tanh(length * std::sqrt(p[2] / p[0]));
  return kappa * (p[4] + kappa * t) / (kappa + p[4] * t);
}

/// Pulled end when the length s slips.
template <class Number>
State<Number> at_slip(const std::array<Number, 5>& p, double s) {
  const Number front = sticking_stiffness<Number>(p, p[1] - s) * p[3] / p[2];
  return {front + p[3] * s, p[3] / p[2] + (front * s + 0.5 * p[3] * s * s) / p[0]};
}

std::array<double, 5> array(const MenqBar::Values& v) {
  return {v.axial_stiffness, v.length, v.interface_stiffness, v.slip_force, v.end_spring};
}

/// The bar without interface behind the spring: the stiffness at the pulled end after macroslip.
double sliding_stiffness(const MenqBar::Values& v) {
  return v.end_spring / (1.0 + v.end_spring * v.length / v.axial_stiffness);
}

/// Where an increasing function of the slipped length changes sign, by bisection to the last digit.
template <class Excess>
double slip_front(double length, Excess excess) {
  double low = 0.0, high = length;
  for (int i = 0; i < 200 && high - low > 1e-16 * length; ++i) {
    const double s = 0.5 * (low + high);
    (excess(s) > 0.0 ? high : low) = s;
  }
  return 0.5 * (low + high);
}

}  // namespace

MenqBar::MenqBar(const Values& values) : values_(values) {
  const auto all = array(values_);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (std::isfinite(all[i]) && (all[i] > 0.0 || (i == 4 && all[i] == 0.0))) continue;
    refuse("menq bar: value " + std::to_string(i + 1) + " = " + std::to_string(all[i]) +
                                " must be finite and > 0 (the end spring >= 0)");
  }
}

double MenqBar::slipped_length(double u) const {
  const auto p = array(values_);
  if (u <= values_.slip_force / values_.interface_stiffness) return 0.0;
  if (u >= at_slip(p, values_.length).displacement) return values_.length;
  return slip_front(values_.length, [&](double s) { return at_slip(p, s).displacement - u; });
}

/// The sticking rest in series with the slipped bar: dF/dU = 1/(s/EA + 1/K(L−s)).
Response MenqBar::response(double u) const {
  const auto p = array(values_);
  const double s = slipped_length(u);
  if (s >= values_.length) {
    const auto end = at_slip(p, s);
    return {end.force + sliding_stiffness(values_) * (u - end.displacement), sliding_stiffness(values_)};
  }
  const double rest = sticking_stiffness(p, values_.length - s);
  if (s == 0.0) return {rest * u, rest};
  const double tangent = rest / (1.0 + rest * s / values_.axial_stiffness);
  const auto at = at_slip(p, s);
  return {at.force + tangent * (u - at.displacement), tangent};
}

/// Elastic energy of the sticking rest and of the slipped bar, and ∫(τu − τ²/(2k)) over the slipped length.
double MenqBar::energy(double u) const {
  const auto p = array(values_);
  const double s = slipped_length(u), slip = values_.slip_force / values_.interface_stiffness;
  const double rest = sticking_stiffness(p, values_.length - s), tau = values_.slip_force;
  if (s == 0.0) return 0.5 * rest * u * u;
  const double front = rest * slip, strain = 1.0 / values_.axial_stiffness;
  double total = 0.5 * rest * slip * slip;
  total += strain * s * (front * front + front * tau * s + tau * tau * s * s / 3.0) / 2.0;
  total += tau * s * (0.5 * slip + strain * s * (front / 2.0 + tau * s / 6.0));
  const double beyond = std::max(u - at_slip(p, s).displacement, 0.0);
  if (s < values_.length) return total;
  return total + beyond * (at_slip(p, s).force + 0.5 * sliding_stiffness(values_) * beyond);
}

double MenqBar::displacement(double force) const {
  const auto p = array(values_);
  const auto first = at_slip(p, 0.0), last = at_slip(p, values_.length);
  if (force <= first.force) return force / sticking_stiffness(p, values_.length);
  if (force > last.force) {
    return values_.end_spring > 0.0 ? last.displacement + (force - last.force) / sliding_stiffness(values_) : infinity;
  }
  const double s = slip_front(values_.length, [&](double length) { return at_slip(p, length).force - force; });
  return at_slip(p, s).displacement;
}

double MenqBar::limit() const {
  return values_.end_spring > 0.0 ? infinity : values_.slip_force * values_.length;
}

std::vector<double> MenqBar::kinks() const {
  const auto p = array(values_);
  return {at_slip(p, 0.0).displacement, at_slip(p, values_.length).displacement};
}

std::vector<Parameter> MenqBar::parameters() const {
  return {{.name = "EA", .unit = "N", .value = values_.axial_stiffness},
          {.name = "L", .unit = "m", .value = values_.length},
          {.name = "k", .unit = "N/m^2", .value = values_.interface_stiffness},
          {.name = "tau", .unit = "N/m", .value = values_.slip_force},
          {.name = "beta", .unit = "N/m", .value = values_.end_spring, .lower_included = true}};
}

/// ∂T/∂p at fixed u is ∂F/∂p − T′ ∂U/∂p at fixed s; both by a complex step, which is exact to rounding.
void MenqBar::derivative(double u, std::span<double> out) const {
  const auto p = array(values_);
  const double s = slipped_length(u);
  const Response at = response(u);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double step = 1e-30 * (p[i] > 0.0 ? p[i] : 1.0);
    std::array<std::complex<double>, 5> q;
    std::copy(p.begin(), p.end(), q.begin());
    q[i] += std::complex<double>(0.0, step);
    if (s == 0.0) {
      out[i] = (sticking_stiffness(q, q[1]) * u).imag() / step;
      continue;
    }
    if (s < values_.length) {
      const auto moved = at_slip(q, s);
      out[i] = (moved.force - at.tangent * moved.displacement).imag() / step;
      continue;
    }
    const std::complex<double> sliding = q[4] / (1.0 + q[4] * q[1] / q[0]);
    // All of L slips: force β·slip + τL and the displacement there move with L too.
    const std::complex<double> slip = q[3] / q[2], front = q[4] * slip;
    const std::complex<double> end = slip + (front * q[1] + 0.5 * q[3] * q[1] * q[1]) / q[0];
    out[i] = (front + q[3] * q[1] + sliding * (u - end)).imag() / step;
  }
}

std::unique_ptr<Element> MenqBar::with(std::span<const double> values) const {
  if (values.size() != 5) refuse("menq bar: " + std::to_string(values.size()) + " values for 5");
  return std::make_unique<MenqBar>(Values{values[0], values[1], values[2], values[3], values[4]});
}

}  // namespace jointid::friction

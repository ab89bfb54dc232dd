#include "friction/path/element.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "friction/path/quadrature.hpp"

namespace jointid::friction {

/// T is concave, so Newton's steps from the left stay left of the solution and rise; the last one is rounding.
double Element::displacement(double force) const {
  if (force > limit()) return infinity;
  const std::vector<double> pieces = kinks();
  const auto next_kink = std::ranges::partition_point(pieces, [&](double u) { return response(u).force <= force; });
  double u = next_kink == pieces.begin() ? 0.0 : *(next_kink - 1);
  for (int iteration = 0; iteration < 200; ++iteration) {
    const Response at = response(u);
    if (!(at.force < force)) return u;
    const double next = u + (force - at.force) / at.tangent;
    if (!(next > u)) return u;
    if (!std::isfinite(next)) return at.tangent > 0.0 ? infinity : u;
    u = next;
  }
  return u;
}

double Element::cycle_energy(double u) const { return 8.0 * energy(u) - 4.0 * u * response(u).force; }

double Element::equivalent_stiffness(double u) const {
  // With u(1 − cos θ)/2 = u sin²φ, θ = 2φ.
  std::vector<double> angles = {0.0};
  for (const double kink : kinks()) {
    if (kink < u) angles.push_back(std::asin(std::sqrt(kink / u)));
  }
  angles.push_back(0.5 * std::numbers::pi);
  const auto integrand = [&](double angle) {
    const double sine = std::sin(angle), sine2 = std::sin(2.0 * angle);
    return response(u * sine * sine).tangent * sine2 * sine2;
  };
  return 4.0 / std::numbers::pi * integrate(integrand, angles);
}

double Element::second_moment(double u) const {
  std::vector<double> ends = {0.0};
  for (const double kink : kinks()) {
    if (kink < u) ends.push_back(kink);
  }
  ends.push_back(u);
  return integrate([this](double v) { return v * v * response(v).force; }, ends);
}

void Element::second_moment_derivative(double u, std::span<double> out) const {
  std::vector<double> ends = {0.0}, one(out.size());
  for (const double kink : kinks()) {
    if (kink < u) ends.push_back(kink);
  }
  ends.push_back(u);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto integrand = [&](double v) {
      derivative(v, one);
      return v * v * one[i];
    };
    out[i] = integrate(integrand, ends);
  }
}

bool Element::admits(std::span<const double> values) const {
  return std::ranges::equal(parameters(), values, [](const Parameter& parameter, double value) {
    const bool above = parameter.lower_included ? value >= parameter.lower : value > parameter.lower;
    return std::isfinite(value) && above && value < parameter.upper;
  });
}

std::vector<double> Element::values() const {
  std::vector<double> result;
  for (const Parameter& parameter : parameters()) result.push_back(parameter.value);
  return result;
}

}  // namespace jointid::friction

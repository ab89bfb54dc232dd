#include "friction/law/burdekin.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "friction/path/cancellation_free.hpp"

namespace jointid::friction {
namespace {

constexpr std::array burdekin_parameters = {LawParameter{"a", "N/m", 0.0, infinity}, LawParameter{"b", "N/m^2", -infinity, 0.0}};
constexpr std::array burdekin_shapes = {0.0};

std::vector<double> burdekin_start(const Features& f, double) {
  return {f.stiffness, -0.25 * f.stiffness * f.stiffness / f.limit};
}

}  // namespace

const Law Burdekin::law = {"burdekin", "parabola (Burdekin)", burdekin_parameters, {burdekin_shapes, burdekin_start}};

Burdekin::Burdekin(std::span<const double> values) : ListedLaw(values) {
  stiffness_ = values[0];
  curvature_ = values[1];
}

double Burdekin::limit() const { return 0.5 * stiffness_ * slip(); }

Response Burdekin::response(double u) const {
  if (u < slip()) return {u * (stiffness_ + curvature_ * u), stiffness_ + 2.0 * curvature_ * u};
  return {limit(), 0.0};
}

double Burdekin::energy(double u) const {
  const double v = std::min(u, slip());
  return v * v * (stiffness_ / 2.0 + curvature_ * v / 3.0) + limit() * (u - v);
}

double Burdekin::displacement(double force) const {
  if (force > limit()) return infinity;
  const double discriminant = stiffness_ * stiffness_ + 4.0 * curvature_ * force;
  return 2.0 * force / (stiffness_ + std::sqrt(std::max(discriminant, 0.0)));
}

void Burdekin::derivative(double u, std::span<double> out) const {
  const double v = std::min(u, slip());
  out[0] = v;
  out[1] = v * v;
}

double Burdekin::cycle_energy(double u) const {
  const double v = std::min(u, slip());
  return -4.0 / 3.0 * curvature_ * v * v * v + 4.0 * limit() * (u - v);
}

double Burdekin::equivalent_stiffness(double u) const {
  // T′ = a + bu(1 − cos θ) against sin²θ, up to macroslip at θ*.
  const double end = u > slip() ? 2.0 * std::asin(std::sqrt(slip() / u)) : std::numbers::pi;
  const double sine = std::sin(end);
  return 2.0 / std::numbers::pi *
         ((stiffness_ + curvature_ * u) * 0.5 * circular_segment(end) - curvature_ * u * sine * sine * sine / 3.0);
}

double Burdekin::second_moment(double u) const {
  const double v = std::min(u, slip()), v3 = v * v * v;
  return v3 * v * (stiffness_ / 4.0 + curvature_ * v / 5.0) + limit() * (u * u * u - v3) / 3.0;
}

void Burdekin::second_moment_derivative(double u, std::span<double> out) const {
  const double v = std::min(u, slip()), v3 = v * v * v, slipped = (u * u * u - v3) / 3.0;
  out[0] = v3 * v / 4.0 + v * slipped;
  out[1] = v3 * v * v / 5.0 + v * v * slipped;
}

}  // namespace jointid::friction

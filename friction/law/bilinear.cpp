#include "friction/law/bilinear.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "friction/path/cancellation_free.hpp"

namespace jointid::friction {
namespace {

constexpr std::array bilinear_parameters = {LawParameter{"a", "m", 0.0, infinity}, LawParameter{"k", "N/m", 0.0, infinity}};
constexpr std::array bilinear_shapes = {0.0};

std::vector<double> bilinear_start(const Features& f, double) { return {f.limit / f.stiffness, f.stiffness}; }

}  // namespace

const Law Bilinear::law = {"bilinear", "bilinear (Jenkins)", bilinear_parameters, {bilinear_shapes, bilinear_start}};

Bilinear::Bilinear(std::span<const double> values) : ListedLaw(values) {
  slip_ = values[0];
  stiffness_ = values[1];
}

Response Bilinear::response(double u) const {
  if (u < slip_) return {stiffness_ * u, stiffness_};
  return {limit(), 0.0};
}

double Bilinear::energy(double u) const {
  const double elastic = std::min(u, slip_);
  return stiffness_ * elastic * (u - 0.5 * elastic);
}

double Bilinear::displacement(double force) const { return force <= limit() ? force / stiffness_ : infinity; }

void Bilinear::derivative(double u, std::span<double> out) const {
  out[0] = u < slip_ ? 0.0 : stiffness_;
  out[1] = std::min(u, slip_);
}

double Bilinear::cycle_energy(double u) const { return 4.0 * limit() * std::max(u - slip_, 0.0); }

double Bilinear::equivalent_stiffness(double u) const {
  if (u <= slip_) return stiffness_;
  // Over the part of the half cycle where it sticks: θ* = acos(1 − 2a/u).
  return stiffness_ / std::numbers::pi * circular_segment(2.0 * std::asin(std::sqrt(slip_ / u)));
}

double Bilinear::second_moment(double u) const {
  const double elastic = std::min(u, slip_), elastic3 = elastic * elastic * elastic;
  return stiffness_ * (elastic3 * elastic / 4.0 + slip_ * (u * u * u - elastic3) / 3.0);
}

void Bilinear::second_moment_derivative(double u, std::span<double> out) const {
  const double elastic = std::min(u, slip_), slipped = (u * u * u - elastic * elastic * elastic) / 3.0;
  out[0] = stiffness_ * slipped;
  out[1] = second_moment(u) / stiffness_;
}

}  // namespace jointid::friction

#include "friction/law/iwan.hpp"

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <numbers>

#include "friction/path/cancellation_free.hpp"

namespace jointid::friction {
namespace {

constexpr std::array iwan_parameters = {LawParameter{"f", "N", 0.0, infinity}, LawParameter{"k", "N/m", 0.0, infinity},
                                          LawParameter{"chi", "1", -1.0, infinity},
                                          LawParameter{"beta", "1", 0.0, infinity, true}};
constexpr std::array iwan_shapes = {-0.7, -0.3, 0.2};

std::vector<double> iwan_start(const Features& f, double chi) { return {f.limit, f.stiffness, chi, 0.3}; }

}  // namespace

const Law Iwan::law = {"iwan", "four-parameter Iwan (Segalman)", iwan_parameters, {iwan_shapes, iwan_start}};

Iwan::Iwan(std::span<const double> values) : ListedLaw(values) {
  limit_ = values[0];
  stiffness_ = values[1];
  exponent_ = values[2];
  ratio_ = values[3];
  slip_ = limit_ * (1.0 + ratio_) / (stiffness_ * (ratio_ + (exponent_ + 1.0) / (exponent_ + 2.0)));
}

/// r^{χ+1}/(1+β), the share of the stiffness that has slipped at u ≤ φ_max.
double Iwan::loss_of_stiffness(double u) const { return std::pow(u / slip_, exponent_ + 1.0) / (1.0 + ratio_); }

Response Iwan::response(double u) const {
  if (u >= slip_) return {limit_, 0.0};
  const double loss = loss_of_stiffness(u);
  return {std::min(stiffness_ * u * (1.0 - loss / (exponent_ + 2.0)), limit_), stiffness_ * (1.0 - loss)};
}

double Iwan::energy(double u) const {
  const double v = std::min(u, slip_);
  const double share = loss_of_stiffness(v) / ((exponent_ + 2.0) * (exponent_ + 3.0));
  return stiffness_ * v * v * (0.5 - share) + limit_ * (u - v);
}

void Iwan::derivative(double u, std::span<double> out) const {
  std::ranges::fill(out, 0.0);
  out[0] = 1.0;
  if (u >= slip_) return;
  const double power = exponent_ + 1.0, next = exponent_ + 2.0, rest = ratio_ + power / next;
  const double share = loss_of_stiffness(u) / next, lost = stiffness_ * u * share;
  out[0] = lost * power / limit_;
  out[1] = u * (1.0 - share - share * power);
  out[2] = u > 0.0 ? -lost * (std::log(u / slip_) + power / (next * next * rest) - 1.0 / next) : 0.0;
  out[3] = lost * ((power + 1.0) / (1.0 + ratio_) - power / rest);
}

/// 4Ru^{χ+3}/((χ+2)(χ+3)) up to φ_max.
double Iwan::cycle_energy(double u) const {
  const double v = std::min(u, slip_);
  const double share = loss_of_stiffness(v) * (exponent_ + 1.0) / ((exponent_ + 2.0) * (exponent_ + 3.0));
  return 4.0 * stiffness_ * v * v * share + 4.0 * limit_ * (u - v);
}

/// ∫ sin^{2p}(θ/2) sin²θ dθ up to θ* is 4 B_x(p + 3/2, 3/2) with x = sin²(θ*/2), the part of the half cycle that sticks.
double Iwan::equivalent_stiffness(double u) const {
  const double x = std::min(slip_ / u, 1.0), power = exponent_ + 1.0;
  const double linear = circular_segment(2.0 * std::asin(std::sqrt(x)));
  const double lost = 8.0 * loss_of_stiffness(u) * boost::math::beta(power + 1.5, 1.5, x);
  return stiffness_ / std::numbers::pi * (linear - lost);
}

double Iwan::second_moment(double u) const {
  const double v = std::min(u, slip_), v3 = v * v * v;
  const double share = loss_of_stiffness(v) / ((exponent_ + 2.0) * (exponent_ + 5.0));
  return stiffness_ * v3 * v * (0.25 - share) + limit_ * (u * u * u - v3) / 3.0;
}

/// ∂T/∂p is a constant times v(1, v^{χ+1}, v^{χ+1} ln v): integrated term by term.
void Iwan::second_moment_derivative(double u, std::span<double> out) const {
  const double v = std::min(u, slip_), power = exponent_ + 1.0, next = exponent_ + 2.0, fifth = exponent_ + 5.0;
  const double rest = ratio_ + power / next, v4 = v * v * v * v;
  const double share = loss_of_stiffness(v) / next, lost = stiffness_ * v4 * share / fifth;
  out[0] = lost * power / limit_ + (u * u * u - v * v * v) / 3.0;
  out[1] = v4 / 4.0 - v4 * share * next / fifth;
  out[2] = v > 0.0 ? -lost * (std::log(v / slip_) - 1.0 / fifth + power / (next * next * rest) - 1.0 / next) : 0.0;
  out[3] = lost * (next / (1.0 + ratio_) - power / rest);
}

}  // namespace jointid::friction

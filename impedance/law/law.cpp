#include "impedance/law/law.hpp"

#include <cmath>

namespace jointid::impedance {
namespace {

constexpr Complex i_unit{0.0, 1.0};
constexpr double reference = 1000.0;  // rad/s

/// (K₀ + K_∞ s)/(1 + s) and its derivatives by K₀, K_∞, τ and, with a fourth parameter, α.
LawValue zener_value(double omega, const Eigen::VectorXd& theta) {
  const double tau = theta(2), alpha = theta.size() > 3 ? theta(3) : 1.0;
  const Complex s = std::pow(i_unit * omega * tau, alpha);
  LawValue out{(theta(0) + theta(1) * s) / (1.0 + s), Eigen::VectorXcd(theta.size())};
  const Complex by_s = (theta(1) - theta(0)) / ((1.0 + s) * (1.0 + s));
  out.slope(0) = 1.0 / (1.0 + s);
  out.slope(1) = s / (1.0 + s);
  out.slope(2) = by_s * s * alpha / tau;
  if (theta.size() > 3) out.slope(3) = omega > 0.0 ? by_s * s * std::log(i_unit * omega * tau) : Complex(0.0);
  return out;
}

/// k₀ + k₁u + … + i(d₀ + d₁u + …).
LawValue polynomial_value(double omega, const Eigen::VectorXd& theta) {
  const Eigen::Index terms = theta.size() / 2;
  LawValue out{0.0, Eigen::VectorXcd(theta.size())};
  double power = 1.0;
  for (Eigen::Index m = 0; m < terms; ++m, power *= omega / reference) {
    out.slope(m) = power;
    out.slope(terms + m) = i_unit * power;
    out.z += theta(m) * out.slope(m) + theta(terms + m) * out.slope(terms + m);
  }
  return out;
}

LawValue linear_value(const Eigen::VectorXd& theta, std::initializer_list<Complex> slopes) {
  LawValue out{0.0, Eigen::VectorXcd(theta.size())};
  Eigen::Index k = 0;
  for (const Complex slope : slopes) {
    out.slope(k) = slope;
    out.z += theta(k++) * slope;
  }
  return out;
}

}  // namespace

const std::vector<std::string>& law_names() {
  static const std::vector<std::string> words = {"hysteretic", "kelvin-voigt",     "zener", "fractional-zener", "linear",
                                                 "quadratic",  "kelvin-voigt-mass"};
  return words;
}

std::string name(LawKind law) { return law_names()[static_cast<std::size_t>(law)]; }

std::vector<LawParameter> parameters_of(LawKind law, const std::string& stiffness) {
  const std::string viscous = stiffness + "*s", mass = stiffness + "*s^2";
  switch (law) {
    case LawKind::hysteretic:
      return {{"K", stiffness}, {"D", stiffness}};
    case LawKind::kelvin_voigt:
      return {{"K", stiffness}, {"C", viscous}};
    case LawKind::zener:
      return {{"K0", stiffness}, {"Kinf", stiffness}, {"tau", "s"}};
    case LawKind::fractional_zener:
      return {{"K0", stiffness}, {"Kinf", stiffness}, {"tau", "s"}, {"alpha", "1"}};
    case LawKind::linear:
      return {{"k0", stiffness}, {"k1", stiffness}, {"d0", stiffness}, {"d1", stiffness}};
    case LawKind::quadratic:
      return {{"k0", stiffness}, {"k1", stiffness}, {"k2", stiffness}, {"d0", stiffness}, {"d1", stiffness}, {"d2", stiffness}};
    case LawKind::kelvin_voigt_mass:
      break;
  }
  return {{"K", stiffness}, {"C", viscous}, {"m", mass}};
}

LawValue law_value(LawKind law, double omega, const Eigen::VectorXd& theta) {
  switch (law) {
    case LawKind::hysteretic:
      return linear_value(theta, {1.0, i_unit});
    case LawKind::kelvin_voigt:
      return linear_value(theta, {1.0, i_unit * omega});
    case LawKind::zener:
    case LawKind::fractional_zener:
      return zener_value(omega, theta);
    case LawKind::linear:
    case LawKind::quadratic:
      return polynomial_value(omega, theta);
    case LawKind::kelvin_voigt_mass:
      break;
  }
  return linear_value(theta, {1.0, i_unit * omega, -omega * omega});
}

std::size_t shape_count(LawKind law) { return law == LawKind::zener ? 1 : law == LawKind::fractional_zener ? 2 : 0; }

}  // namespace jointid::impedance

#include "oscillation/system/timoshenko.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "base/eigen.hpp"
#include "base/error.hpp"

namespace jointid::oscillation {
namespace {

using Function = std::function<double(double)>;

/// The root between two ends of different sign, to the last digits.
double bisected(const Function& f, double low, double high) {
  const bool rises = f(low) < 0.0;
  for (int i = 0; i < 200 && high - low > 4e-16 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (f(middle) < 0.0) == rises ? low = middle : high = middle;
  }
  return 0.5 * (low + high);
}

/// The first `count` positive roots of a function whose roots are more than `step` apart.
std::vector<double> first_roots(const Function& f, std::size_t count, double step) {
  std::vector<double> roots;
  double from = step, value = f(from);
  while (roots.size() < count) {
    const double to = from + step, next = f(to);
    if ((value < 0.0) != (next < 0.0)) roots.push_back(bisected(f, from, to));
    from = to, value = next;
  }
  return roots;
}

/// Euler and Bernoulli's characteristic function over cosh z, μ the tip mass over the beam's.
double euler_function(double z, double mu) {
  return 1.0 / std::cosh(z) + std::cos(z) + mu * z * (std::cos(z) * std::tanh(z) - std::sin(z));
}

/// ∫₀¹ of a smooth function: Simpson's rule.
double integral(const Function& f) {
  constexpr int parts = 4000;
  double sum = f(0.0) + f(1.0);
  for (int i = 1; i < parts; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * f(static_cast<double>(i) / parts);
  return sum / (3.0 * parts);
}

/// φ and its derivatives over zx, x from 0 to 1: cosh zx − cos zx − σ(sinh zx − sin zx), written without differences of large
/// numbers.
struct BendingShape {
  explicit BendingShape(double root)
      : z(root), excess((std::exp(-z) + std::cos(z) - std::sin(z)) / (std::sinh(z) + std::sin(z))) {}

  double at(double x, int derivative) const {
    const double t = z * x, sigma = 1.0 + excess;
    const bool odd = derivative % 2 == 1;
    const double rest = odd ? std::cosh(t) : std::sinh(t);
    const double hyperbolic = (odd ? -std::exp(-t) : std::exp(-t)) - excess * rest;
    const std::array<double, 4> round = {-std::cos(t) + sigma * std::sin(t), std::sin(t) + sigma * std::cos(t),
                                         std::cos(t) - sigma * std::sin(t), -std::sin(t) - sigma * std::cos(t)};
    return hyperbolic + round[static_cast<std::size_t>(derivative)];
  }
  double squares(int derivative) const {
    return integral([&](double x) { return at(x, derivative) * at(x, derivative); });
  }

  double z, excess;
};

/// e^B for a small B.
Eigen::Matrix4d exponential(const Eigen::Matrix4d& b) {
  Eigen::Matrix4d out = Eigen::Matrix4d::Identity(), term = out;
  for (int k = 1; k <= 20; ++k) {
    term = (term * b / k).eval();
    out += term;
  }
  return out;
}

/// Numbers of the beam, lengths over L, with ω² = z⁴ EI/(ρA L⁴).
struct Ratios {
  double shear, rotary, mass;  ///< EI/(κGA L²), I/(A L²), m/(ρA L)
};

/// The state {w, ψ, M, Q} along the beam: w' = ψ + sQ, ψ' = M, M' = −Q − rz⁴ψ, Q' = −z⁴w; at the tip M = 0 and Q = μz⁴w.
double timoshenko_function(double z, const Ratios& ratios) {
  constexpr int segments = 128;
  const double z4 = z * z * z * z;
  Eigen::Matrix4d a = Eigen::Matrix4d::Zero();
  a(0, 1) = 1.0, a(0, 3) = ratios.shear;
  a(1, 2) = 1.0;
  a(2, 1) = -ratios.rotary * z4, a(2, 3) = -1.0;
  a(3, 0) = -z4;
  const Eigen::Matrix4d step = exponential(a / segments);
  Eigen::Matrix<double, 4, 2> state = Eigen::Matrix<double, 4, 2>::Zero();
  state(2, 0) = state(3, 1) = 1.0;
  for (int i = 0; i < segments; ++i) {
    state = (step * state).eval();
    // Columns stay apart: the second loses its part along the first, which leaves the determinant.
    state.col(1) -= state.col(0) * (state.col(0).dot(state.col(1)) / state.col(0).squaredNorm());
  }
  const Eigen::RowVector2d shear = state.row(3) - ratios.mass * z4 * state.row(0);
  const double scale = state.col(0).norm() * state.col(1).norm() * (1.0 + z4);
  return (state(2, 0) * shear(1) - state(2, 1) * shear(0)) / scale;
}

void require_positive(double value, const char* place) {
  if (value > 0.0 && std::isfinite(value)) return;
  throw InputError({ErrorKind::usage, "", place, "is not above 0", ""});
}

void check(const ThickBeam& beam, std::size_t count) {
  require_positive(beam.length, "length");
  require_positive(beam.width, "width");
  require_positive(beam.thickness, "thickness");
  require_positive(beam.youngs_modulus, "youngs_modulus");
  require_positive(beam.density, "density");
  if (!(beam.tip_mass >= 0.0)) throw InputError({ErrorKind::usage, "", "tip_mass", "is below 0", ""});
  if (!(beam.poisson_ratio > -1.0 && beam.poisson_ratio <= 0.5))
    throw InputError({ErrorKind::usage, "", "poisson_ratio", "is " + std::to_string(beam.poisson_ratio), "take 0 to 0.5"});
  if (count == 0) throw InputError({ErrorKind::usage, "", "modes", "are none", ""});
}

}  // namespace

double ThickBeam::bending_stiffness() const { return youngs_modulus * width * thickness * thickness * thickness / 12.0; }
double ThickBeam::mass_per_length() const { return density * width * thickness; }
double ThickBeam::rotary_inertia() const { return density * width * thickness * thickness * thickness / 12.0; }
double ThickBeam::shear_coefficient() const { return 10.0 * (1.0 + poisson_ratio) / (12.0 + 11.0 * poisson_ratio); }
double ThickBeam::shear_stiffness() const {
  return shear_coefficient() * youngs_modulus / (2.0 * (1.0 + poisson_ratio)) * width * thickness;
}

std::vector<ThickMode> thick_modes(const ThickBeam& beam, std::size_t count) {
  check(beam, count);
  constexpr double step = 0.02;  // of z; modes are more than 1 apart, of thick beams more than a tenth
  const double square = beam.length * beam.length;
  const Ratios ratios = {beam.bending_stiffness() / (beam.shear_stiffness() * square),
                         beam.rotary_inertia() / (beam.mass_per_length() * square),
                         beam.tip_mass / (beam.mass_per_length() * beam.length)};
  const double unit = std::sqrt(beam.bending_stiffness() / beam.mass_per_length()) / square / (2.0 * std::numbers::pi);
  const std::vector<double> euler = first_roots([&](double z) { return euler_function(z, ratios.mass); }, count, step);
  const std::vector<double> thick = first_roots([&](double z) { return timoshenko_function(z, ratios); }, count, step);
  std::vector<ThickMode> out;
  for (std::size_t k = 0; k < count; ++k) {
    const BendingShape shape(euler[k]);
    const double z2 = euler[k] * euler[k], tip = shape.at(1.0, 0);
    out.push_back({.euler_hz = unit * z2,
                   .rotary = -0.5 * ratios.rotary * z2 * shape.squares(1) / (shape.squares(0) + ratios.mass * tip * tip),
                   .shear = -0.5 * ratios.shear * z2 * shape.squares(3) / shape.squares(2),
                   .timoshenko_hz = unit * thick[k] * thick[k]});
  }
  return out;
}

}  // namespace jointid::oscillation

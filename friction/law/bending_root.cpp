#include "friction/law/bending_root.hpp"

#include <array>
#include <cmath>
#include <complex>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "friction/path/quadrature.hpp"

namespace jointid::friction {
namespace {

constexpr double complex_step = 1e-30;

/// The part of the displacement at the loaded end that comes from slip in the root, u_L + θ_L L₀.
template <class Number>
Number slip_displacement(const Number& force, const Number& stiffness, const Number& tau, const Number& length) {
  const Number d = force / tau, a = std::sqrt(d * length + 0.5 * d * d), b = a + d;
  const Number shift = (a * a * a * a + 4.0 * a * a * a * b + 6.0 * a * a * b * b + 4.0 * a * b * b * b - b * b * b * b) / 24.0;
  const Number turn = (a * a * a + 3.0 * a * a * b + 3.0 * a * b * b - b * b * b) / 6.0;
  return tau / stiffness * (shift + turn * length);
}

template <class Number>
Number end_displacement(const Number& force, const Number& stiffness, const Number& tau, const Number& length) {
  return slip_displacement(force, stiffness, tau, length) + force * length * length * length / (3.0 * stiffness);
}

}  // namespace

BendingRoot::BendingRoot(double bending_stiffness, double slip_force, double free_length)
    : bending_stiffness_(bending_stiffness), slip_force_(slip_force), free_length_(free_length) {
  for (const double value : {bending_stiffness, slip_force, free_length}) {
    if (value > 0.0 && std::isfinite(value)) continue;
    refuse("bending root: " + std::to_string(value) + " must be finite and > 0");
  }
}

double BendingRoot::displacement(double force) const {
  return end_displacement(force, bending_stiffness_, slip_force_, free_length_);
}

double BendingRoot::root_displacement(double force) const {
  return slip_displacement(force, bending_stiffness_, slip_force_, free_length_);
}

/// ∫ of root_displacement over the force; with the force g² it is analytic in g.
double BendingRoot::root_impulse(double force) const {
  return integrate_smooth([this](double g) { return 2.0 * g * root_displacement(g * g); },
                          std::array{0.0, 0.25 * std::sqrt(force), 0.5 * std::sqrt(force), std::sqrt(force)});
}

/// Newton; u(F) is convex and starts with the compliance L₀³/(3EI), so the steps come from above.
double BendingRoot::force(double u) const {
  double force = 3.0 * bending_stiffness_ * u / (free_length_ * free_length_ * free_length_);
  for (int iteration = 0; iteration < 100; ++iteration) {
    const Complex at = end_displacement<Complex>({force, complex_step * force}, bending_stiffness_, slip_force_, free_length_);
    const double next = force - (at.real() - u) * complex_step * force / at.imag();
    if (!(next < force)) break;
    force = next;
  }
  return force;
}

Response BendingRoot::response(double u) const {
  if (u < 1e-100) {  // complex steps of it would be zero
    const double stiffness = 3.0 * bending_stiffness_ / (free_length_ * free_length_ * free_length_);
    return {stiffness * u, stiffness};
  }
  const double force = this->force(u);
  const Complex at = end_displacement<Complex>({force, complex_step * force}, bending_stiffness_, slip_force_, free_length_);
  return {force, complex_step * force / at.imag()};
}

double BendingRoot::energy(double u) const {
  const double force = this->force(u), compliance = (u - root_displacement(force)) / 2.0;
  return force * (u - compliance) - root_impulse(force);
}

/// The free beam loses nothing: 4Fu_root − 8∫u_root dF.
double BendingRoot::cycle_energy(double u) const {
  const double force = this->force(u);
  return 4.0 * force * root_displacement(force) - 8.0 * root_impulse(force);
}

double BendingRoot::slipped_length(double force) const {
  const double d = force / slip_force_;
  return 2.0 * std::sqrt(d * free_length_ + 0.5 * d * d) + d;
}

std::vector<Parameter> BendingRoot::parameters() const {
  return {{.name = "EI", .unit = "N*m^2", .value = bending_stiffness_},
          {.name = "tau", .unit = "N/m", .value = slip_force_},
          {.name = "L0", .unit = "m", .value = free_length_}};
}

/// ∂T/∂p at fixed u is −(∂u/∂p)/(∂u/∂F).
void BendingRoot::derivative(double u, std::span<double> out) const {
  const Response at = response(u);
  const std::array values = {bending_stiffness_, slip_force_, free_length_};
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::array<std::complex<double>, 3> p = {values[0], values[1], values[2]};
    p[i] += std::complex<double>(0.0, complex_step * values[i]);
    const std::complex<double> moved = end_displacement<std::complex<double>>(at.force, p[0], p[1], p[2]);
    out[i] = -moved.imag() / (complex_step * values[i]) * at.tangent;
  }
}

std::unique_ptr<Element> BendingRoot::with(std::span<const double> values) const {
  if (values.size() != 3) refuse("bending root: " + std::to_string(values.size()) + " values for 3");
  return std::make_unique<BendingRoot>(values[0], values[1], values[2]);
}

}  // namespace jointid::friction

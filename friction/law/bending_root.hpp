#pragma once

#include "friction/path/element.hpp"

namespace jointid::friction {

/// Root of a clamped beam of unit width with dry friction (docs/formulas.md §10e, thesis §2.7.2), loaded by a force F at the
/// length L₀ outside of the clamp. Inside, the length b slips forward and a behind it backward (2.14, 2.15 with M = FL₀): a =
/// √(FL₀/τ + F²/(2τ²)), b = a + F/τ. Euler beam, nothing moves behind a + b, so that at the mouth u_L = (τ/EI)(−b⁴ + 4ab³ + 6a²b²
/// + 4a³b + a⁴)/24, θ_L = (τ/EI)(−b³ + 3ab² + 3a²b + a³)/6, and at the loaded end u = u_L + θ_L L₀ + FL₀³/(3EI), which is
/// (2.24–2.30) with the moment b²τ/2 for the printed bτ²/2 of (2.23). The clamp is as long as the slip needs: there is no limit,
/// slipped_length says how far it reaches. The model lets the zone a move forward although friction pushes it forward; with
/// friction against the motion everywhere (a FiniteElementJoint of a beam) the joint is stiffer, by 3.7 % in displacement at F =
/// 0.2 τL₀.
class BendingRoot final : public Element {
 public:
  /// EI (N·m²), τ (N/m), L₀ (m), all > 0. Throws InputError.
  BendingRoot(double bending_stiffness, double slip_force, double free_length);

  Response response(double u) const override;
  double energy(double u) const override;
  double displacement(double force) const override;
  double limit() const override { return infinity; }
  std::vector<Parameter> parameters() const override;
  void derivative(double u, std::span<double> out) const override;
  std::unique_ptr<Element> with(std::span<const double> values) const override;
  double cycle_energy(double u) const override;

  /// a + b under this force.
  double slipped_length(double force) const;

 private:
  double root_displacement(double force) const;
  double root_impulse(double force) const;
  double force(double u) const;

  double bending_stiffness_, slip_force_, free_length_;
};

}  // namespace jointid::friction

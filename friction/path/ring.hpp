#pragma once

#include <memory>

#include "friction/path/element.hpp"

namespace jointid::friction {

/// Rotary joint between the faces of two rings r₁ … r₂ (docs/formulas.md §10d, 2.65): torque M(θ) = ∫ 2πr²τ(rθ) dr, where τ(u) is
/// a law per area (N/m² over m). It is an element itself, of torque (N·m) over angle (rad); its parameters are those of τ per
/// area. With Q(u) = ∫₀^u v²τ dv, M = (2π/θ³)(Q(r₂θ) − Q(r₁θ)): in closed form for the laws of laws.hpp, which for Ren, Shoukry
/// and Burdekin is (2.72), (2.68) and (2.70) with 6b for the printed 12b.
class Ring final : public Element {
 public:
  /// 0 ≤ inner < outer (m). Throws InputError.
  Ring(std::shared_ptr<const Element> law, double inner, double outer);

  Response response(double angle) const override;
  double energy(double angle) const override;
  double limit() const override;
  std::vector<double> kinks() const override;
  std::vector<Parameter> parameters() const override;
  void derivative(double angle, std::span<double> out) const override;
  bool admits(std::span<const double> values) const override { return law_->admits(values); }
  std::unique_ptr<Element> with(std::span<const double> values) const override;
  double cycle_energy(double angle) const override;

 private:
  /// Radii between which the law is analytic at this angle.
  std::vector<double> rings(double angle) const;

  std::shared_ptr<const Element> law_;
  double inner_, outer_;
};

}  // namespace jointid::friction

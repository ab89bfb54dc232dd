#pragma once

#include <array>

#include "friction/path/element.hpp"

namespace jointid::friction {

/// Menq's elastic bar on a rigid base with a bilinear interface, pulled at its end (docs/formulas.md §10e): slip starts at the
/// pulled end and grows over a length s. With K(ℓ) the stiffness of a bar of length ℓ that sticks, F = K(L−s)τ/k + τs, U = τ/k +
/// (F − τs)s/EA + τs²/(2EA), K(ℓ) = κ(β + κt)/(κ + βt), κ = √(kEA), t = tanh(ℓ√(k/EA)). β = 0 gives (2.39), (2.43) with η = 0;
/// the printed (2.43) has a product where the quotient of (2.39) is meant. After macroslip the spring β alone resists, through
/// the bar.
class MenqBar final : public Element {
 public:
  struct Values {
    double axial_stiffness = 0.0;    ///< EA, N
    double length = 0.0;             ///< L, m
    double interface_stiffness = 0.0;  ///< k, N/m per m
    double slip_force = 0.0;         ///< τ, N/m
    double end_spring = 0.0;         ///< β ≥ 0 at the far end, N/m
  };

  /// Throws InputError.
  explicit MenqBar(const Values& values);

  Response response(double u) const override;
  double energy(double u) const override;
  double displacement(double force) const override;
  double limit() const override;
  std::vector<double> kinks() const override;
  std::vector<Parameter> parameters() const override;
  void derivative(double u, std::span<double> out) const override;
  std::unique_ptr<Element> with(std::span<const double> values) const override;

  /// Length of the part that slips.
  double slipped_length(double u) const;

 private:
  Values values_;
};

}  // namespace jointid::friction

#pragma once

#include "friction/path/assembly.hpp"

namespace jointid::friction {

/// Elements one behind the other: the same force, u = Σ u_i(T). The one with the least limit slips; it takes all of the
/// displacement after macroslip. With w that element, T = T_w(v) where v + Σ_{i≠w} u_i(T_w(v)) = u.
class Series final : public Assembly {
 public:
  explicit Series(Parts parts);

  Response response(double u) const override;
  double energy(double u) const override;
  double displacement(double force) const override;
  double limit() const override { return weakest().limit(); }
  std::vector<double> kinks() const override;
  void derivative(double u, std::span<double> out) const override;
  std::unique_ptr<Element> with(std::span<const double> values) const override;
  double cycle_energy(double u) const override;

  /// Displacement of each part at u.
  std::vector<double> displacements(double u) const;

 private:
  struct Stretch {
    double total = 0.0;       ///< displacement of the whole
    double slope = 0.0;       ///< its derivative by that of the weakest
    Response weakest;
  };

  const Element& weakest() const { return *parts()[weakest_]; }
  Stretch stretch(double v) const;
  double displacement_of_weakest(double u) const;

  std::size_t weakest_ = 0;
};

}  // namespace jointid::friction

#pragma once

#include <array>
#include <cstddef>

#include "friction/law/listed_law.hpp"

namespace jointid::friction {

/// One choice of u(h), the displacement at which the share h of the stiffness has slipped (docs/formulas.md §10a, 2.49–2.57),
/// with the integrals that its law needs. `p` are the parameters without the stiffness.
struct PowerSlip {
  static constexpr std::size_t parameters = 3;
  using Values = std::array<double, parameters>;
  static double begin(const Values& p) { return p[0]; }
  static double share(const Values& p, double u);
  static double first(const Values& p, double h);                ///< ∫₀ʰ u dη
  static double second(const Values& p, double h);               ///< ∫₀ʰ u² dη
  static Values first_by_parameters(const Values& p, double h);  ///< ∂/∂p of first
  static double at(const Values& p, double h);
};

struct SquareSlip {
  static constexpr std::size_t parameters = 2;
  using Values = std::array<double, parameters>;
  static double begin(const Values& p) { return p[0]; }
  static double share(const Values& p, double u);
  static double first(const Values& p, double h);
  static double second(const Values& p, double h);
  static Values first_by_parameters(const Values& p, double h);
  static double at(const Values& p, double h);
};

struct OffsetSlip {
  static constexpr std::size_t parameters = 3;
  using Values = std::array<double, parameters>;
  static double begin(const Values& p) { return p[0] + p[2]; }
  static double share(const Values& p, double u);
  static double first(const Values& p, double h);
  static double second(const Values& p, double h);
  static Values first_by_parameters(const Values& p, double h);
  static double at(const Values& p, double h);
};

/// The microslip element with the u(h) of `Slip`: T = k(∫₀ʰu dη + (1 − h)u) with u(h) = u, T′ = k(1 − h) (2.51), from u(1) on
/// k∫₀¹u dη. Parameters: those of Slip, then k (N/m).
template <class Slip>
class SlipLaw final : public ListedLaw<SlipLaw<Slip>> {
 public:
  static const Law law;

  explicit SlipLaw(std::span<const double> values);

  Response response(double u) const override;
  double energy(double u) const override;
  double limit() const override { return stiffness_ * Slip::first(slip_, 1.0); }
  std::vector<double> kinks() const override;
  std::vector<Parameter> parameters() const override;
  void derivative(double u, std::span<double> out) const override;
  double cycle_energy(double u) const override;

 private:
  double share(double u) const;

  typename Slip::Values slip_;
  double stiffness_;
};

template <>
const Law SlipLaw<PowerSlip>::law;
template <>
const Law SlipLaw<SquareSlip>::law;
template <>
const Law SlipLaw<OffsetSlip>::law;

using Power = SlipLaw<PowerSlip>;               ///< "power": u = a + b h^c, a ≥ 0 and b m, c > 0
using Square = SlipLaw<SquareSlip>;             ///< "square": u = a + b h²
using ExponentialOffset = SlipLaw<OffsetSlip>;  ///< "exponential-offset": u = a e^{bh} + c, u(0) = a + c > 0

extern template class SlipLaw<PowerSlip>;
extern template class SlipLaw<SquareSlip>;
extern template class SlipLaw<OffsetSlip>;

}  // namespace jointid::friction

#pragma once

#include <vector>

#include "friction/path/element.hpp"

namespace jointid::friction {

/// A point of u(h): at displacement u the share h of the stiffness slips.
struct SlipPoint {
  double share = 0.0;
  double displacement = 0.0;
};

/// The generalised microslip element (docs/formulas.md §10a, 2.51) with u(h) given by a table and linear between its points:
/// T = k(∫₀^h u dh + (1 − h)u(h)), dT/du = k(1 − h). Any law that obeys Masing's rule is of this form (§2.11.2). A table that
/// ends at h < 1 leaves the share 1 − h elastic for ever: the joint then has no limit.
class GeneralizedSlip final : public Element {
 public:
  /// Shares increase from 0 to at most 1, displacements are > 0 and do not decrease, stiffness > 0 (N/m).
  /// Throws InputError.
  GeneralizedSlip(double stiffness, std::vector<SlipPoint> table);

  Response response(double u) const override;
  double energy(double u) const override;
  double limit() const override;
  std::vector<double> kinks() const override;
  std::vector<Parameter> parameters() const override;  ///< k, u0, u1, …
  void derivative(double u, std::span<double> out) const override;
  bool admits(std::span<const double> values) const override;
  std::unique_ptr<Element> with(std::span<const double> values) const override;
  double cycle_energy(double u) const override;
  double second_moment(double u) const override;

  const std::vector<SlipPoint>& table() const { return table_; }

 private:
  /// Sums over the slipped shares: stretches of u(h) between two points.
  template <class Figure>
  double slipped(double u, Figure figure) const;
  double share(double u) const;

  double stiffness_;
  std::vector<SlipPoint> table_;
};

}  // namespace jointid::friction

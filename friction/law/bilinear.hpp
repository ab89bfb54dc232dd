#pragma once

#include <array>

#include "friction/law/listed_law.hpp"

namespace jointid::friction {

/// Spring and dry friction in series (Jenkins): T = min(ku, ka).
class Bilinear final : public ListedLaw<Bilinear> {
 public:
  static const Law law;

  /// {a, k}: displacement at slip (m), stiffness (N/m).
  explicit Bilinear(std::span<const double> values);

  Response response(double u) const override;
  double energy(double u) const override;
  double displacement(double force) const override;
  double limit() const override { return stiffness_ * slip_; }
  std::vector<double> kinks() const override { return {slip_}; }
  std::vector<Parameter> parameters() const override { return with_values(law, std::array{slip_, stiffness_}); }
  void derivative(double u, std::span<double> out) const override;
  double cycle_energy(double u) const override;
  double equivalent_stiffness(double u) const override;
  double second_moment(double u) const override;
  void second_moment_derivative(double u, std::span<double> out) const override;

 private:
  double slip_, stiffness_;
};

}  // namespace jointid::friction

#pragma once

#include <array>

#include "friction/law/listed_law.hpp"

namespace jointid::friction {

/// T = ku; a part of assemblies.
class Spring final : public ListedLaw<Spring> {
 public:
  static const Law law;

  /// {k}: stiffness (N/m).
  explicit Spring(std::span<const double> values);

  Response response(double u) const override;
  double energy(double u) const override;
  double displacement(double force) const override;
  double limit() const override { return infinity; }
  std::vector<Parameter> parameters() const override { return with_values(law, std::array{stiffness_}); }
  void derivative(double u, std::span<double> out) const override;
  double cycle_energy(double u) const override;
  double equivalent_stiffness(double u) const override;
  double second_moment(double u) const override;
  void second_moment_derivative(double u, std::span<double> out) const override;

 private:
  double stiffness_;
};

}  // namespace jointid::friction

#pragma once

#include <array>

#include "friction/law/listed_law.hpp"

namespace jointid::friction {

/// T = au + bu² for u < −a/(2b), then −a²/(4b) (docs/formulas.md §10a; 2.44, b < 0).
class Burdekin final : public ListedLaw<Burdekin> {
 public:
  static const Law law;

  /// {a, b}: initial stiffness (N/m), curvature (N/m², negative).
  explicit Burdekin(std::span<const double> values);

  Response response(double u) const override;
  double energy(double u) const override;
  double displacement(double force) const override;
  double limit() const override;
  std::vector<double> kinks() const override { return {slip()}; }
  std::vector<Parameter> parameters() const override { return with_values(law, std::array{stiffness_, curvature_}); }
  void derivative(double u, std::span<double> out) const override;
  double cycle_energy(double u) const override;
  double equivalent_stiffness(double u) const override;
  double second_moment(double u) const override;
  void second_moment_derivative(double u, std::span<double> out) const override;

 private:
  double slip() const { return -0.5 * stiffness_ / curvature_; }

  double stiffness_, curvature_;
};

}  // namespace jointid::friction

#pragma once

#include <array>

#include "friction/law/listed_law.hpp"

namespace jointid::friction {

/// T = a(1 − e^{−bu}) (docs/formulas.md §10a, 2.45); with a = T_s, ab = K the law of Rogers (2.46). It reaches its limit only
/// asymptotically.
class Shoukry final : public ListedLaw<Shoukry> {
 public:
  static const Law law;

  /// {a, b}: limit (N), inverse length (1/m).
  explicit Shoukry(std::span<const double> values);

  Response response(double u) const override;
  double energy(double u) const override;
  double displacement(double force) const override;
  double limit() const override { return limit_; }
  std::vector<Parameter> parameters() const override { return with_values(law, std::array{limit_, rate_}); }
  void derivative(double u, std::span<double> out) const override;
  double cycle_energy(double u) const override;
  double equivalent_stiffness(double u) const override;
  double second_moment(double u) const override;
  void second_moment_derivative(double u, std::span<double> out) const override;

 private:
  double limit_, rate_;
};

}  // namespace jointid::friction

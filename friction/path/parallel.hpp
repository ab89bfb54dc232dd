#pragma once

#include "friction/path/assembly.hpp"

namespace jointid::friction {

/// Elements side by side: T(u) = Σ T_i(u).
class Parallel final : public Assembly {
 public:
  using Assembly::Assembly;

  Response response(double u) const override;
  double energy(double u) const override;
  double limit() const override;
  std::vector<double> kinks() const override;
  void derivative(double u, std::span<double> out) const override;
  std::unique_ptr<Element> with(std::span<const double> values) const override;
  double cycle_energy(double u) const override;
  double equivalent_stiffness(double u) const override;
  double second_moment(double u) const override;
  void second_moment_derivative(double u, std::span<double> out) const override;
};

}  // namespace jointid::friction

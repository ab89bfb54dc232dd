#pragma once

#include <memory>

#include "friction/path/element.hpp"

namespace jointid::friction {

/// A law under `load` times the normal load that it belongs to: λ T(u/λ). Slip limits, and the displacements where slip begins, are in
/// proportion to the load; the stiffness of the sticking joint stays (docs/formulas.md §10).
class Clamped final : public Element {
 public:
  /// load > 0, finite. Throws InputError.
  Clamped(std::shared_ptr<const Element> law, double load);

  Response response(double u) const override;
  double energy(double u) const override { return load_ * load_ * law_->energy(u / load_); }
  double displacement(double force) const override { return load_ * law_->displacement(force / load_); }
  double limit() const override { return load_ * law_->limit(); }
  std::vector<double> kinks() const override;
  std::vector<Parameter> parameters() const override { return law_->parameters(); }
  void derivative(double u, std::span<double> out) const override;
  bool admits(std::span<const double> values) const override { return law_->admits(values); }
  std::unique_ptr<Element> with(std::span<const double> values) const override;
  double cycle_energy(double u) const override { return load_ * load_ * law_->cycle_energy(u / load_); }
  double equivalent_stiffness(double u) const override { return law_->equivalent_stiffness(u / load_); }
  double second_moment(double u) const override;
  void second_moment_derivative(double u, std::span<double> out) const override;

 private:
  std::shared_ptr<const Element> law_;
  double load_;
};

}  // namespace jointid::friction

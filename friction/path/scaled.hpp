#pragma once

#include <memory>

#include "friction/path/element.hpp"

namespace jointid::friction {

/// `factor` · T(u/`stretch`). With factor alone a law per area or per length over the area or length that it acts on. With both equal a
/// law under so many times the normal load that it belongs to: slip limits, and the displacements where slip begins, are in proportion to
/// the load, and the stiffness of the sticking joint stays (docs/formulas.md §10).
class Scaled final : public Element {
 public:
  /// factor > 0, stretch > 0. Throws InputError.
  Scaled(std::shared_ptr<const Element> law, double factor, double stretch = 1.0);

  Response response(double u) const override;
  double energy(double u) const override { return factor_ * stretch_ * law_->energy(u / stretch_); }
  double displacement(double force) const override { return stretch_ * law_->displacement(force / factor_); }
  double limit() const override { return factor_ * law_->limit(); }
  std::vector<double> kinks() const override;
  std::vector<Parameter> parameters() const override { return law_->parameters(); }
  void derivative(double u, std::span<double> out) const override;
  bool admits(std::span<const double> values) const override { return law_->admits(values); }
  std::unique_ptr<Element> with(std::span<const double> values) const override;
  double cycle_energy(double u) const override { return factor_ * stretch_ * law_->cycle_energy(u / stretch_); }
  double equivalent_stiffness(double u) const override { return factor_ / stretch_ * law_->equivalent_stiffness(u / stretch_); }
  double second_moment(double u) const override { return moment_factor() * law_->second_moment(u / stretch_); }
  void second_moment_derivative(double u, std::span<double> out) const override;

 private:
  /// ∫₀^u v² T(v/s) dv = s³ ∫₀^(u/s) w² T(w) dw.
  double moment_factor() const { return factor_ * stretch_ * stretch_ * stretch_; }

  std::shared_ptr<const Element> law_;
  double factor_, stretch_;
};

}  // namespace jointid::friction

#pragma once

#include <memory>

#include "friction/path/element.hpp"

namespace jointid::friction {

/// `factor` times the force of a law: a law per area or per length over the area or length that it acts on.
class Scaled final : public Element {
 public:
  /// factor > 0. Throws InputError.
  Scaled(std::shared_ptr<const Element> law, double factor);

  Response response(double u) const override;
  double energy(double u) const override { return factor_ * law_->energy(u); }
  double displacement(double force) const override { return law_->displacement(force / factor_); }
  double limit() const override { return factor_ * law_->limit(); }
  std::vector<double> kinks() const override { return law_->kinks(); }
  std::vector<Parameter> parameters() const override { return law_->parameters(); }
  void derivative(double u, std::span<double> out) const override;
  bool admits(std::span<const double> values) const override { return law_->admits(values); }
  std::unique_ptr<Element> with(std::span<const double> values) const override;
  double cycle_energy(double u) const override { return factor_ * law_->cycle_energy(u); }
  double equivalent_stiffness(double u) const override { return factor_ * law_->equivalent_stiffness(u); }
  double second_moment(double u) const override { return factor_ * law_->second_moment(u); }
  void second_moment_derivative(double u, std::span<double> out) const override;

 private:
  std::shared_ptr<const Element> law_;
  double factor_;
};

}  // namespace jointid::friction

#include "friction/path/scaled.hpp"

#include <cmath>

#include "base/error.hpp"

namespace jointid::friction {

Scaled::Scaled(std::shared_ptr<const Element> law, double factor, double stretch)
    : law_(std::move(law)), factor_(factor), stretch_(stretch) {
  for (const double each : {factor_, stretch_}) {
    if (!(each > 0.0) || !std::isfinite(each)) refuse("scaled friction law: factor " + std::to_string(each) + " must be finite and > 0");
  }
}

Response Scaled::response(double u) const {
  const Response one = law_->response(u / stretch_);
  return {factor_ * one.force, factor_ / stretch_ * one.tangent};
}

std::vector<double> Scaled::kinks() const {
  std::vector<double> all = law_->kinks();
  for (double& kink : all) kink *= stretch_;
  return all;
}

void Scaled::derivative(double u, std::span<double> out) const {
  law_->derivative(u / stretch_, out);
  for (double& value : out) value *= factor_;
}

std::unique_ptr<Element> Scaled::with(std::span<const double> values) const {
  return std::make_unique<Scaled>(law_->with(values), factor_, stretch_);
}

void Scaled::second_moment_derivative(double u, std::span<double> out) const {
  law_->second_moment_derivative(u / stretch_, out);
  for (double& value : out) value *= moment_factor();
}

}  // namespace jointid::friction

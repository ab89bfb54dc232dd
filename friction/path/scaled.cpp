#include "friction/path/scaled.hpp"

#include <cmath>

#include "base/error.hpp"

namespace jointid::friction {

Scaled::Scaled(std::shared_ptr<const Element> law, double factor) : law_(std::move(law)), factor_(factor) {
  if (!(factor_ > 0.0) || !std::isfinite(factor_)) {
    refuse("scaled friction law: factor " + std::to_string(factor_) + " must be finite and > 0");
  }
}

Response Scaled::response(double u) const {
  const Response one = law_->response(u);
  return {factor_ * one.force, factor_ * one.tangent};
}

void Scaled::derivative(double u, std::span<double> out) const {
  law_->derivative(u, out);
  for (double& value : out) value *= factor_;
}

std::unique_ptr<Element> Scaled::with(std::span<const double> values) const {
  return std::make_unique<Scaled>(law_->with(values), factor_);
}

void Scaled::second_moment_derivative(double u, std::span<double> out) const {
  law_->second_moment_derivative(u, out);
  for (double& value : out) value *= factor_;
}

}  // namespace jointid::friction

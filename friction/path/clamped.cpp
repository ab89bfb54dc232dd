#include "friction/path/clamped.hpp"

#include <cmath>

#include "base/error.hpp"

namespace jointid::friction {
namespace {

/// Of ∫v²λT(v/λ)dv in ∫w²T(w)dw, w = v/λ.
double moment_factor(double load) { return load * load * load * load; }

}  // namespace

Clamped::Clamped(std::shared_ptr<const Element> law, double load) : law_(std::move(law)), load_(load) {
  if (!(load_ > 0.0) || !std::isfinite(load_)) {
    refuse("clamped friction law: a load of " + std::to_string(load_) + " times that of the law must be finite and > 0");
  }
}

Response Clamped::response(double u) const {
  const Response one = law_->response(u / load_);
  return {load_ * one.force, one.tangent};
}

std::vector<double> Clamped::kinks() const {
  std::vector<double> all = law_->kinks();
  for (double& kink : all) kink *= load_;
  return all;
}

void Clamped::derivative(double u, std::span<double> out) const {
  law_->derivative(u / load_, out);
  for (double& value : out) value *= load_;
}

std::unique_ptr<Element> Clamped::with(std::span<const double> values) const {
  return std::make_unique<Clamped>(law_->with(values), load_);
}

double Clamped::second_moment(double u) const { return moment_factor(load_) * law_->second_moment(u / load_); }

void Clamped::second_moment_derivative(double u, std::span<double> out) const {
  law_->second_moment_derivative(u / load_, out);
  for (double& value : out) value *= moment_factor(load_);
}

}  // namespace jointid::friction

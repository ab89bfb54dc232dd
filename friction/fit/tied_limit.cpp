#include "friction/fit/tied_limit.hpp"

#include <cmath>

namespace jointid::friction {
namespace {

/// A displacement where the force is the limit to rounding.
double beyond_macroslip(const Element& element) {
  const std::vector<double> kinks = element.kinks();
  const double scale = std::max(element.limit() / element.response(0.0).tangent, kinks.empty() ? 0.0 : kinks.back());
  return 1e3 * scale;
}

/// p/limit · ∂limit/∂p.
std::vector<double> elasticities(const Element& element) {
  std::vector<double> out = limit_derivative(element);
  const std::vector<double> values = element.values();
  for (std::size_t i = 0; i < out.size(); ++i) out[i] *= values[i] / element.limit();
  return out;
}

std::unique_ptr<Element> changed(const Element& element, std::size_t parameter, double value) {
  std::vector<double> values = element.values();
  values[parameter] = value;
  return element.admits(values) ? element.with(values) : nullptr;
}

}  // namespace

std::vector<double> limit_derivative(const Element& element) {
  std::vector<double> out(element.parameters().size());
  element.derivative(beyond_macroslip(element), out);
  return out;
}

std::vector<double> stiffness_derivative(const Element& element, double largest) {
  const double small = 1e-150 * largest;  // laws with a power of u lose stiffness at once
  std::vector<double> out(element.parameters().size());
  element.derivative(small, out);
  for (double& each : out) each /= small;
  return out;
}

std::optional<std::size_t> tied_parameter(const Element& element, const std::vector<bool>& spared) {
  if (!std::isfinite(element.limit())) return std::nullopt;
  const std::vector<double> by = elasticities(element);
  std::optional<std::size_t> best;
  const auto badness = [&](std::size_t i) { return std::abs(std::abs(by[i]) - 1.0) + (spared[i] ? 1e3 : 0.0); };
  for (std::size_t i = 0; i < by.size(); ++i) {
    if (std::abs(by[i]) > 1e-6 && (!best || badness(i) < badness(*best))) best = i;
  }
  return best;
}

std::unique_ptr<Element> with_limit(const Element& element, std::size_t parameter, double limit) {
  constexpr int most = 60;
  std::unique_ptr<Element> at = element.clone();
  for (int step = 0; step < most; ++step) {
    const double missing = std::log(limit / at->limit());
    if (std::abs(missing) < 4e-16) return at;
    const double by = elasticities(*at)[parameter];
    auto next = changed(*at, parameter, at->values()[parameter] * std::exp(missing / by));
    if (!next) return nullptr;
    const bool last = std::abs(std::log(limit / next->limit())) >= std::abs(missing);
    if (last && std::abs(missing) < 1e-12) return at;
    at = std::move(next);
  }
  return nullptr;
}

}  // namespace jointid::friction

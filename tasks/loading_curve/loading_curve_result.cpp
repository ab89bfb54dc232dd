#include "tasks/loading_curve/loading_curve_result.hpp"

#include <algorithm>
#include <cmath>

#include "friction/path/loops.hpp"

namespace jointid::tasks {

std::vector<friction::Equivalent> equivalents(const friction::CurveFit& fit, std::size_t count) {
  std::vector<double> amplitudes;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    amplitudes.push_back(fit.curve.largest_displacement() * 0.05 * std::pow(40.0, share));
  }
  return friction::equivalent(*fit.element, amplitudes);
}

std::vector<const friction::CurveFit*> different(const LoadingCurveResult& result, const friction::Fit& fit) {
  std::vector<const friction::CurveFit*> out;
  for (const friction::CurveFit& each : fit.curves) out.push_back(&each);
  if (result.data.loops && out.size() > 1) out.resize(1);
  return out;
}

double energy_error(const friction::CurveFit& fit) {
  const friction::Loop loop{{fit.curve.u, fit.curve.value}, fit.curve.turn};
  return fit.element->cycle_energy(loop.amplitude()) / loop.energy() - 1.0;
}

bool some_usable(const LoadingCurveResult& result) {
  return std::ranges::any_of(result.fits, [](const friction::Fit& fit) { return fit.status == Status::ok; });
}

}  // namespace jointid::tasks

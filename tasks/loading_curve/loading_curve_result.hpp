#pragma once

#include <string>
#include <vector>

#include "friction/curve/equivalent.hpp"
#include "friction/curve/slip_shares.hpp"
#include "friction/fit/fit.hpp"
#include "tasks/loading_curve/loading_curve_data.hpp"

namespace jointid::tasks {

/// The laws fitted to loading curves (hysteresis backbones) or loops: what `jointid loading-curve` found.
struct LoadingCurveResult {
  std::string title;  ///< names of the files; empty for curves in memory
  LoadingCurveData data;
  std::vector<friction::Fit> fits;                   ///< of all curves together, best by AIC first
  std::vector<friction::SlipShares> slopes{};        ///< where they are asked for, one per curve
  std::vector<std::vector<friction::Fit>> of_loops;  ///< with several loops: by fit, the same law fitted to each loop alone
};

/// Equivalent stiffness and damping of an element on `count` amplitudes in even ratios from 1/20 of the curve's largest
/// displacement to twice that: m and N/m (rad and N·m/rad of rotary joints), energy per cycle in J.
std::vector<friction::Equivalent> equivalents(const friction::CurveFit& fit, std::size_t count);

/// Elements of a fit that differ: one when loops share theirs, else one per curve.
std::vector<const friction::CurveFit*> different(const LoadingCurveResult& result, const friction::Fit& fit);

/// Energy of the cycle by the element over the measured one, −1; of a curve that is a loop.
double energy_error(const friction::CurveFit& fit);

/// Whether some fit is usable.
bool some_usable(const LoadingCurveResult& result);

}  // namespace jointid::tasks

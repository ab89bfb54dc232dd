#pragma once

#include <string>
#include <vector>

#include "report/loading_curve/loading_curve_data.hpp"
#include "friction/curve/equivalent.hpp"
#include "friction/fit/fit.hpp"

namespace jointid::report {

/// What `jointid loading-curve` found.
struct LoadingCurveReport {
  std::string title;  ///< the files
  LoadingCurveData data;
  std::vector<friction::Fit> fits;                    ///< of all curves together, best by AIC first
  std::vector<std::vector<friction::Fit>> of_loops;   ///< with several loops: by fit, the same law fitted to each loop alone
};

/// Equivalent stiffness and damping of an element on `count` amplitudes in even ratios from 1/20 of the curve's largest
/// displacement to twice that.
std::vector<friction::Equivalent> equivalents(const friction::CurveFit& fit, std::size_t count);

/// Elements of a fit that differ: one when loops share theirs, else one per curve.
std::vector<const friction::CurveFit*> different(const LoadingCurveReport& report, const friction::Fit& fit);

/// Energy of the cycle by the element over the measured one, −1; of a curve that is a loop.
double energy_error(const friction::CurveFit& fit);

/// Smallest, median and largest.
struct Range {
  double low = 0.0, median = 0.0, high = 0.0;
};
Range range(std::vector<double> values);

/// Whether some fit is usable.
bool some_usable(const LoadingCurveReport& report);

}  // namespace jointid::report

#pragma once

#include <array>
#include <string>
#include <vector>

#include "ident/result/control.hpp"
#include "ident/scene/scene.hpp"
#include "tasks/bound_report.hpp"

namespace jointid::tasks {

/// What solving a scene would take and give, before it is solved.
struct JointForecast {
  std::size_t unknowns = 0;
  double seconds = 0.0;  ///< of the iterations (ident::expected_seconds()); 0 where nothing iterates
  /// Smallest standard errors at the joint that Method One finds from a few lines, scaled to all lines. `relative` is to
  /// `value`. Empty where `why` states the
  /// reason: it is not asked for more than 150 unknowns.
  std::vector<UnknownBound> bounds;
  std::string why;
};

/// Plans the scene, finds its joint from at most 60 lines and the bound there. The bounds are those of predict_bound() times
/// √(lines looked at / all lines), as of lines that tell as much each. Throws InputError where it cannot be planned, and Interrupted.
JointForecast forecast_joint(const ident::Scene& scene, const ident::Control& control = {});

/// Relative half width of the 95 % interval, 1.96 bound/|value|, of the unknown in the middle and of the worst; infinite for unknowns that
/// the data do not determine. Two zeros without bounds.
std::array<double, 2> relative_intervals(const JointForecast& forecast);

}  // namespace jointid::tasks

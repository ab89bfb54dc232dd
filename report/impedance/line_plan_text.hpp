#pragma once

#include <string>

#include "impedance/line_plan.hpp"

namespace jointid::report {

/// What is read and found at a line, and where Z will be seen, for reading.
std::string line_plan_text(const impedance::LineScene& scene, const impedance::LinePlan& plan);

/// The same as JSON. "bound" has the standard errors of every element at every line, of real and imaginary part and √(E|δz|²)/|z|, and
/// those of the laws' parameters.
std::string line_plan_json(const impedance::LineScene& scene, const impedance::LinePlan& plan);

}  // namespace jointid::report

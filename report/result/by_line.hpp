#pragma once

#include <string>

#include "tasks/convergence.hpp"

namespace jointid::report {

/// "lines,frequency_hz", each unknown from the lines so far, then each from the last of them alone ("K(1,1) alone").
std::string by_line_csv(const tasks::UnknownsByLine& found);
/// The keys stay.
std::string by_line_json(const tasks::UnknownsByLine& found);

/// "iteration,objective", then each unknown.
std::string by_iteration_csv(const tasks::UnknownsByIteration& found);
/// The keys stay.
std::string by_iteration_json(const tasks::UnknownsByIteration& found);

}  // namespace jointid::report

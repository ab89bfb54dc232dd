#include "tasks/oscillate/oscillate_result.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace jointid::tasks {

using oscillation::MotionEnd;

std::string failure_of(const OscillateResult& run) {
  if (run.motion->status == MotionEnd::too_long)
    return "the motion ended: too_long, its steps are all taken; shorten transient and length, or is a stiffness or a frequency "
           "too high?";
  if (run.motion->status != MotionEnd::ok) return fmt::format("the motion ended: {}", word(run.motion->status));
  if (run.orbit && !run.orbit->converged) return "the periodic orbit was not found";
  if (run.exponents && run.exponents->status != MotionEnd::ok) return fmt::format("exponents: {}", word(run.exponents->status));
  const auto lost = std::ranges::count_if(run.sweep, [](const auto& point) { return point.status != MotionEnd::ok; });
  if (lost > 0) return fmt::format("{} of {} motions of the sweep did not end well", lost, run.sweep.size());
  if (run.reduction &&
      std::ranges::any_of(run.reduction->rows, [](const ReducedRow& row) { return row.error.status != MotionEnd::ok; }))
    return "a reduced model did not end well";
  return "";
}

}  // namespace jointid::tasks

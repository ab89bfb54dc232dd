#include "tasks/response/response_result.hpp"

#include <algorithm>

namespace jointid::tasks {

using response::HarmonicSolution;

Eigen::Index first_row(const HarmonicSolution& solution) { return solution.harmonics.front() == 0 ? 1 : 0; }

bool is_complete(const LevelResponse& level) {
  return level.complete && std::ranges::all_of(level.points, &HarmonicSolution::converged);
}

bool all_converged(const ResponseResult& run) {
  const auto clamping = [](const ClampingRun& each) { return std::ranges::all_of(each.peaks, &ClampedPeak::complete); };
  return std::ranges::all_of(run.levels, is_complete) &&
         std::ranges::all_of(run.curves, [](const CurveRun& each) { return each.found.end == response::CurveEnd::reached; }) &&
         std::ranges::all_of(run.clampings, clamping) &&
         std::ranges::all_of(run.transients, [](const TransientRun& each) { return each.motion.complete; });
}

}  // namespace jointid::tasks

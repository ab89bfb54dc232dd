#include "report/response/response_run.hpp"

#include <algorithm>

namespace jointid::report {

using response::HarmonicSolution;

void tell(const ident::Control& control, const std::string& stage, std::size_t done, std::size_t total) {
  if (control.progress) control.progress(stage.c_str(), done, total);
}

Eigen::Index first_row(const HarmonicSolution& solution) { return solution.harmonics.front() == 0 ? 1 : 0; }

bool all_converged(const ResponseRun& run) {
  const auto level = [](const LevelResponse& each) {
    return each.complete && std::ranges::all_of(each.points, &HarmonicSolution::converged);
  };
  return std::ranges::all_of(run.levels, level) &&
         std::ranges::all_of(run.curves, [](const CurveRun& each) { return each.found.end == response::CurveEnd::reached; }) &&
         std::ranges::all_of(run.transients, [](const TransientRun& each) { return each.motion.complete; });
}

}  // namespace jointid::report

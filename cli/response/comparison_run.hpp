#pragma once

#include <string>
#include <vector>

#include "cli/text/progress.hpp"
#include "report/response/response_scene.hpp"
#include "response/comparison/compare_ways.hpp"

namespace jointid::cli {

/// All ways to the response of one level at one frequency.
struct WaysRun {
  double level = 0.0, frequency_hz = 0.0;
  std::vector<response::WayResult> ways;  ///< the exact one first
};

/// `response --compare`: of the scene's first response, for each level and frequency of [frequency] values. Throws InputError
/// (usage) without matrices or values.
std::vector<WaysRun> run_comparison(const report::ResponseScene& scene, Progress& progress);

/// Whether each case has its exact orbit.
bool all_known(const std::vector<WaysRun>& runs);

/// A table for each case, error beside time.
std::string comparison_text(const report::ResponseScene& scene, const std::vector<WaysRun>& runs);
std::string comparison_json(const report::ResponseScene& scene, const std::vector<WaysRun>& runs);
std::string comparison_csv(const std::vector<WaysRun>& runs);

}  // namespace jointid::cli

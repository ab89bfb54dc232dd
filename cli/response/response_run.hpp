#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/response/response_scene.hpp"
#include "cli/text/progress.hpp"
#include "response/harmonic/deviations.hpp"

namespace jointid::cli {

/// The responses to one force level.
struct LevelResponse {
  double level = 0.0;  ///< N
  std::vector<response::HarmonicSolution> points{};
  std::vector<response::ResponseDeviations> deviations{};  ///< of the points; none when nothing is known
  std::optional<double> peak_deviation{};                  ///< of |X| at the peak
  std::optional<response::HarmonicSolution> peak{};        ///< largest |X| of the first response and lowest harmonic above 0
  bool refined = false;                                    ///< the peak lies between points
  std::vector<response::HarmonicSolution> turning_points{};
  bool complete = true;  ///< every point converged, the curve reached its end
};

struct ResponseRun {
  std::vector<std::string> dofs, joints;
  std::vector<LevelResponse> levels;
  std::vector<std::string> doubts;  ///< one phrase each
};

/// Row of the lowest harmonic above 0.
Eigen::Index first_row(const response::HarmonicSolution& solution);

/// Whether every point of every level has an answer.
bool all_converged(const ResponseRun& run);

/// Reads what the scene needs and computes it.
ResponseRun run_response(const ResponseScene& scene, Progress& progress);

}  // namespace jointid::cli

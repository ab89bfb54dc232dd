#pragma once

#include <vector>

#include "ident/result/control.hpp"
#include "response/comparison/compare_iterations.hpp"
#include "response/comparison/compare_ways.hpp"
#include "tasks/response/response_scene.hpp"

namespace jointid::tasks {

/// All ways to the response of one level at one frequency.
struct WaysResult {
  double level = 0.0;  ///< N
  double frequency_hz = 0.0;
  std::vector<response::WayResult> ways;                ///< the exact one first
  std::vector<response::IterationResult> iterations{};  ///< ways to the solution of harmonic balance itself
};

/// Error against run time of harmonic balance, Algorithms One and Two, against the exact orbit, of the scene's first response,
/// for each level and each of [frequency] values; and the iterations and increments that lead to solutions of harmonic balance.
/// The progress's stage is the case and the way. Throws InputError (usage) for a scene that does not march in time or has no
/// case, and Interrupted.
std::vector<WaysResult> compare_responses(const ResponseScene& scene, const ident::Control& control = {});

/// Whether each case has its exact orbit.
bool all_known(const std::vector<WaysResult>& runs);

}  // namespace jointid::tasks

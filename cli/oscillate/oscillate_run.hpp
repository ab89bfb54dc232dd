#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/oscillate/sampled_motion.hpp"
#include "cli/text/interrupt.hpp"
#include "cli/text/progress.hpp"
#include "oscillation/orbit/return_map.hpp"
#include "oscillation/orbit/sweep.hpp"
#include "series/pod/fraction_error.hpp"

namespace jointid::cli {

/// Proper orthogonal modes of what is seen.
struct SeenModes {
  series::Pod pod;
  series::Fractions fractions;  ///< with jackknife errors
};

/// Models on fewer coordinates.
struct ReducedRow {
  BasisKind basis = BasisKind::pod;
  std::size_t order = 0;
  oscillation::ReductionError error;
};
struct ReductionTable {
  SeenForm judged;
  double full_seconds = 0.0;
  double largest_judged = 0.0;  ///< of the full model
  std::vector<ReducedRow> rows;
};

/// All that `oscillate` found, as far as it came.
struct OscillateRun {
  std::string title;
  SystemSpec system;
  std::shared_ptr<const SampledMotion> motion;  ///< never null
  std::optional<SeenModes> modes;
  std::optional<oscillation::PeriodicOrbit> orbit;
  std::optional<oscillation::Exponents> exponents;
  std::optional<SweepSection> swept;
  std::vector<oscillation::SweepPoint> sweep;
  std::optional<ReductionTable> reduction;
  std::vector<std::string> remarks;
  bool interrupted = false;
};

/// What is wrong with it: empty where all that was asked is there.
std::string failure_of(const OscillateRun& run);

/// Does what the scene asks, in its order; `so_far` gets each part when it is done. Throws Interrupted.
OscillateRun run_oscillate(const OscillateScene& scene, std::size_t threads, Progress& progress, SoFar<OscillateRun>& so_far);

}  // namespace jointid::cli

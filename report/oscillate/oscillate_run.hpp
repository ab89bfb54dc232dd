#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "oscillation/orbit/return_map.hpp"
#include "oscillation/orbit/sweep.hpp"
#include "report/oscillate/sampled_motion.hpp"
#include "series/pod/fraction_error.hpp"

namespace jointid::report {

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

/// How a run is watched and stopped; each may be empty.
struct OscillateControl {
  std::size_t threads = 0;                                    ///< of the sweep; 0: all cores. The results do not depend on it.
  std::function<void(const char* stage, int done)> progress;  ///< per cent; of −1 only the stage is known
  std::function<bool()> interrupted;
  std::function<void(const OscillateRun&)> so_far;  ///< each part when it is done
};

/// Does what the scene asks, in its order. Throws Interrupted.
OscillateRun run_oscillate(const OscillateScene& scene, const OscillateControl& control);

}  // namespace jointid::report

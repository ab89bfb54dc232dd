#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "oscillation/orbit/return_map.hpp"
#include "oscillation/orbit/sweep.hpp"
#include "oscillation/pod/fraction_error.hpp"
#include "tasks/oscillate/sampled_motion.hpp"

namespace jointid::tasks {

/// Proper orthogonal modes of the displacements seen.
struct SeenModes {
  oscillation::Pod pod;
  oscillation::Fractions fractions;  ///< of Σσ², with jackknife errors
};

/// A model on fewer coordinates.
struct ReducedRow {
  BasisKind basis = BasisKind::pod;
  std::size_t order = 0;              ///< coordinates
  oscillation::ReductionError error;  ///< against the full model
};
struct ReductionTable {
  SeenForm judged;
  double full_seconds = 0.0;    ///< run time of the full model
  double largest_judged = 0.0;  ///< largest |judged form| of the full model, in its unit
  std::vector<ReducedRow> rows;
};

/// The sweep of one reduced model.
struct ReducedSweep {
  BasisKind basis = BasisKind::pod;
  std::size_t order = 0;
  std::vector<oscillation::SweepPoint> points;
};

/// The normal load over the slider's frequency.
struct NormalVibrationResult {
  oscillation::NormalVibration system;
  std::vector<double> frequencies_hz, amplitudes;   ///< of the slider
  std::vector<oscillation::NormalMotion> motions;  ///< one per frequency
};

/// All that run_oscillate() found, as far as it came. SI units; a chain without units has its own unit of time. Parts that the
/// scene does not ask for are empty.
struct OscillateResult {
  std::string title;
  SystemSpec system;
  std::shared_ptr<const SampledMotion> motion;  ///< never null
  std::optional<SeenModes> modes;               ///< none of a motion that stands still or did not end well
  std::optional<oscillation::PeriodicOrbit> orbit;
  std::optional<oscillation::Exponents> exponents;  ///< of Lyapunov, nats a second
  std::optional<SweepSection> swept;
  std::vector<oscillation::SweepPoint> sweep;  ///< ascending in the parameter; of a continued sweep in its order
  std::vector<ReducedSweep> reduced_sweeps;    ///< the same of reduced models
  std::optional<double> sliding_limit;         ///< velocity in the range of the sweep below which steady sliding is unstable
  std::optional<ReductionTable> reduction;
  std::optional<NormalVibrationResult> normal_vibrations;
  std::vector<oscillation::ThickMode> thick_modes;  ///< of a cantilever with a Poisson's ratio
  std::vector<std::string> remarks;
  bool interrupted = false;
};

/// What is wrong with it: empty where all that was asked is there.
std::string failure_of(const OscillateResult& run);

}  // namespace jointid::tasks

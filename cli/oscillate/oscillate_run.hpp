#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/oscillate/oscillate_scene.hpp"
#include "cli/text/interrupt.hpp"
#include "cli/text/progress.hpp"
#include "oscillation/orbit/return_map.hpp"
#include "oscillation/orbit/sweep.hpp"
#include "series/pod/fraction_error.hpp"

namespace jointid::cli {

/// A column of the sampled motion.
struct SampledColumn {
  std::string name, unit;
};

/// The motion of the window. Columns: time, what is seen, its velocities, V_r, f, N, and the judged form.
struct SampledMotion {
  oscillation::Status status = oscillation::Status::ok;
  std::size_t seen = 0;  ///< displacements
  std::vector<SampledColumn> columns;
  RowMatrixXd samples;          ///< [samples, columns]
  RowMatrixXd section;          ///< a row a break-away or cycle of the window: what is seen, then its velocities
  Eigen::MatrixXd q;            ///< [n, samples]
  Eigen::VectorXd end;          ///< state
  oscillation::Mode end_mode = oscillation::Mode::forward;
  std::vector<oscillation::Event> break_aways;  ///< of the window, a thousand at most
  std::size_t events = 0;       ///< of the window
  double stick_share = 0.0;     ///< of its time
};

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

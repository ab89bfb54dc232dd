#pragma once

#include <functional>
#include <string>
#include <vector>

#include "oscillation/integrate/stick_slip.hpp"
#include "tasks/oscillate/oscillate_scene.hpp"

namespace jointid::tasks {

/// A column of the sampled motion.
struct SampledColumn {
  std::string name, unit;
};

/// The motion of the window. Columns: time, what is seen, its velocities, V_r, f, N, and the judged form.
struct SampledMotion {
  oscillation::MotionEnd status = oscillation::MotionEnd::ok;
  std::size_t seen = 0;  ///< displacements
  std::vector<SampledColumn> columns;
  RowMatrixXd samples;  ///< [samples, columns]
  RowMatrixXd section;  ///< a row a break-away or cycle of the window: what is seen, then its velocities
  Eigen::MatrixXd q;    ///< [n, samples]
  Eigen::VectorXd end;  ///< state
  oscillation::Mode end_mode = oscillation::Mode::forward;
  std::vector<oscillation::Event> break_aways;  ///< of the window, a thousand at most
  std::size_t events = 0;                       ///< of the window
  double stick_share = 0.0;                     ///< of its time
};

/// Integrates the scene's motion; `share` is told what part of the time is done. Throws Interrupted.
SampledMotion sampled_motion(const OscillateScene& scene, const oscillation::ContactSystem& system,
                             const std::function<void(double)>& share, const std::function<bool()>& interrupted);

}  // namespace jointid::tasks

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "oscillation/integrate/stick_slip.hpp"

namespace jointid::oscillation {

/// What a motion did in the observed time.
struct SweptRange {
  double smallest = 0.0, largest = 0.0;  ///< of the form of ranges
  double stick_share = 0.0;              ///< of the time
  std::size_t break_aways = 0;
  std::size_t slips =
      0;  ///< break-aways, or cycles of the drive, after which the last value comes again to 1e-6 of the range; 0: none
  double period = 0.0;  ///< s, of those; 0 with them
};

/// One parameter of a bifurcation diagram.
struct SweepPoint {
  double parameter = 0.0;
  MotionEnd status = MotionEnd::ok;
  std::vector<double> values;         ///< of the observed form, at break-aways or once a cycle
  std::optional<SweptRange> range{};  ///< where it is asked for
  int direction = 0;                  ///< +1 or −1: reached from the parameter below or above; 0: from a start of its own
};

/// A system, where it starts, which linear form of its state is observed and when, by the parameter.
struct SweepCase {
  ContactSystem system;
  Eigen::VectorXd start, form;
  double transient = 0.0;  ///< s, before values are kept; ≥ 0
  double length = 0.0;     ///< s, > 0
  double cycle = 0.0;      ///< s: values once a cycle of the drive, at its phase 0; 0: at break-aways
  double offset = 0.0;     ///< added to the form
  Eigen::VectorXd range_form{};  ///< whose SweptRange is found, too; empty: none
  double range_offset = 0.0;     ///< added to it
};

struct SweepOptions {
  std::size_t threads = 1;  ///< 0: all cores; the values do not depend on it
  std::function<bool()> interrupted = {};
  std::function<void(const SweepPoint&)> done = {};  ///< called by one thread at a time, in no order
};

/// All parameters, each from its own start, shared among threads.
std::vector<SweepPoint> sweep(const std::vector<double>& parameters, const std::function<SweepCase(double)>& make,
                              const SweepOptions& options = {});

/// The parameters one after the other, each from the last state of the one before (displacements, velocities, the elongation of a
/// contact spring that sticks); the first from its own start. A sweep up and one down show hysteresis. Ends early where a motion
/// does not end well.
std::vector<SweepPoint> continued_sweep(const std::vector<double>& parameters, const std::function<SweepCase(double)>& make,
                                        const SweepOptions& options = {});

}  // namespace jointid::oscillation

#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "oscillation/integrate/stick_slip.hpp"

namespace jointid::oscillation {

/// One parameter of a bifurcation diagram.
struct SweepPoint {
  double parameter = 0.0;
  MotionEnd status = MotionEnd::ok;
  std::vector<double> values;  ///< of the observed form, at break-aways or once a cycle
};

/// A system, where it starts, which linear form of its state is observed and when, by the parameter.
struct SweepCase {
  ContactSystem system;
  Eigen::VectorXd start, form;
  double transient = 0.0;  ///< s, before values are kept; ≥ 0
  double length = 0.0;     ///< s, > 0
  double cycle = 0.0;      ///< s: values once a cycle of the drive, at its phase 0; 0: at break-aways
};

struct SweepOptions {
  std::size_t threads = 1;  ///< 0: all cores; the values do not depend on it
  std::function<bool()> interrupted = {};
  std::function<void(const SweepPoint&)> done = {};  ///< called by one thread at a time, in no order
};

/// All parameters, each from its own start, shared among threads.
std::vector<SweepPoint> sweep(const std::vector<double>& parameters, const std::function<SweepCase(double)>& make,
                              const SweepOptions& options = {});

}  // namespace jointid::oscillation

#pragma once

#include <Eigen/Core>
#include <vector>

#include "virtualpoint/transformation.hpp"

namespace jointid::virtualpoint {

/// A channel whose FRFs are those of another direction.
struct WrongDirection {
  Side side = Side::sensors;
  frf::Dof dof;              ///< as the virtual point names it
  Vector stated{}, found{};  ///< unit vectors, of that DOF
  double residual = 0.0;     ///< mean square of what the modes leave of the other channels, over that with this one: 0 to 1
};

/// Channels whose FRFs the modes explain by another direction than the stated one. `y`: their FRFs line by line, channels are
/// rows; every line counts alike. Channel i is doubted when the mean square residual of the fit to the others, Σ‖y − RTy‖²/(n −
/// m), is less than half of that with it, and the direction d that explains it best from their motion, min Σ|y_i − dᵀ(motion at
/// i)|², is 5° or more off. The worst one first; then the same without it. Nothing is said of fewer than m + 2 channels, whose
/// fit leaves too little over.
std::vector<WrongDirection> wrong_directions(const VirtualPoint& point, Side side, const Transformation& channels,
                                             const std::vector<Eigen::MatrixXcd>& y);

}  // namespace jointid::virtualpoint

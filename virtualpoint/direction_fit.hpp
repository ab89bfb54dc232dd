#pragma once

#include <Eigen/Core>
#include <vector>

#include "virtualpoint/consistency.hpp"

namespace jointid::virtualpoint {

/// Channels whose FRFs the modes explain by another direction than the stated one. `y`: their FRFs line by line, channels are
/// rows; every line counts alike. Channel i is doubted when the mean square residual of the fit to the others, Σ‖y − RTy‖²/(n −
/// m), is less than half of that with it, and the direction d that explains it best from their motion, min Σ|y_i − dᵀ(motion at
/// i)|², is 5° or more off. The worst one first; then the same without it. Nothing is said of fewer than m + 2 channels, whose
/// fit leaves too little over.
std::vector<WrongDirection> wrong_directions(const VirtualPoint& point, Side side, const Transformation& channels,
                                             const std::vector<Eigen::MatrixXcd>& y);

}  // namespace jointid::virtualpoint

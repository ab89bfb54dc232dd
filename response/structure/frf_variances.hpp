#pragma once

#include <Eigen/Core>
#include <vector>

#include "frf/set/frf_system.hpp"

namespace jointid::response {

/// Variances of real and imaginary part of the FRFs rows × columns, line by line, from the files' variances or coherences; 0
/// across uncoupled parts. Empty when a file that has some of them has neither, or one of them is not known.
std::vector<Eigen::MatrixXcd> read_variances(frf::FrfSystem& system, const std::vector<frf::Dof>& rows,
                                             const std::vector<frf::Dof>& columns);

}  // namespace jointid::response

#pragma once

#include <Eigen/Core>
#include <complex>
#include <optional>
#include <vector>

#include "base/complex.hpp"

namespace jointid::coupling {

using Eigen::Index;
using ComplexMatrix = Eigen::MatrixXcd;
using MatrixRef = Eigen::Ref<const ComplexMatrix>;

/// One line of what an assembly demands of its coordinates: x_first − sign·x_second = 0, or x_first = 0 (ground) without a
/// second. Row b of the matrix B in B x = 0; sign is +1 or −1.
struct Condition {
  Index first = 0;
  std::optional<Index> second;
  double sign = 1.0;
};

/// Conditions that do not depend on each other.
using Conditions = std::vector<Condition>;

// The matrix H of a line, receptances of all parts side by side (m/N), is [rows, columns]. Coordinates that conditions or
// joints name come first, in the same order among rows and columns; the other rows and columns may differ.

/// Which FRFs of the assembly to work out, by row and column of H.
struct Wanted {
  std::vector<Index> rows, columns;
};

/// All rows and columns of H.
Wanted everything(const MatrixRef& h);

}  // namespace jointid::coupling

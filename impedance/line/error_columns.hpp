#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "base/complex.hpp"

namespace jointid::impedance {

/// Errors e of measured FRFs as sums of real, independent errors u of variance 1: e = Σ_k column_k u_k, of which only what is not
/// zero is kept, (FRF, factor).
using ErrorColumns = std::vector<std::vector<std::pair<Eigen::Index, Complex>>>;

/// J · column_k, those that are not zero.
Eigen::MatrixXcd errors_of(const Eigen::MatrixXcd& jacobian, const ErrorColumns& columns);

}  // namespace jointid::impedance

#pragma once

#include <Eigen/Core>
#include <vector>

#include "ident/plan/plan.hpp"

namespace jointid::ident {

/// Of every column the largest |value| among those of its matrix and unit; `values` in any one scaling of the columns.
Eigen::VectorXd largest_of_kind(const Plan& plan, const std::vector<double>& values);

}  // namespace jointid::ident

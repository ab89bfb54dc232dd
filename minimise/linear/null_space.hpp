#pragma once

#include <Eigen/Core>

#include "minimise/linear/linear_solution.hpp"

namespace jointid::minimise {

/// Fills free_directions and undetermined from a basis of the null space, [columns × dimension], in scaled unknowns. A
/// column counts as undetermined when its row of the orthonormal basis is longer than √ε: it could have any value.
/// The directions told are those of the basis in which each has a column of its own, so that what does not move together is
/// not named together.
void tell_null_space(const Eigen::MatrixXd& basis, LinearSolution& out);

/// y without its part in the null space: the solution of minimum norm.
Eigen::VectorXd minimum_norm(const Eigen::MatrixXd& basis, const Eigen::VectorXd& y);

}  // namespace jointid::minimise

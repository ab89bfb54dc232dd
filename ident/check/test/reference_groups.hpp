#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "frf/set/dof.hpp"

namespace jointid::ident {

/// The indices whose level is that of an upper group: the split of the logarithms in two that leaves the least variance. Empty
/// unless the geometric means of the groups are a factor of 2 apart and both have an element.
std::vector<std::size_t> upper_group(const std::vector<double>& levels);

/// A group of coordinates that differ from the others and agree among themselves, and so do the others: the split with the
/// largest mean logarithm of cells(i,j) across less that within, from all cuts of the order and single exchanges after that. The
/// smaller part; of equal ones that at the end. Empty unless the means are a factor of 4 apart.
std::vector<std::size_t> group_that_differs(const Eigen::MatrixXd& cells);

/// "101:+Z, 102:+Z … 107:+Z": all of up to 4, else the first two and the last, and how many they are.
std::string group_text(const std::vector<frf::Dof>& dofs);

}  // namespace jointid::ident

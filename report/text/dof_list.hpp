#pragma once

#include <string>
#include <vector>

#include "frf/set/dof.hpp"

namespace jointid::report {

/// "14: 4:+Y 4:+RZ … 17:+X": how many, then all of a few or both ends of many.
std::string dof_list(const std::vector<frf::Dof>& dofs);

}  // namespace jointid::report

#pragma once

#include <vector>

#include "frf/set/dof.hpp"

class QComboBox;

namespace jointid::gui {

/// The names of DOFs to choose from; what was chosen stays, if it is among them.
void fill_dofs(QComboBox& box, const std::vector<frf::Dof>& dofs);

}  // namespace jointid::gui

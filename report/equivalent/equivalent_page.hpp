#pragma once

#include <string>

#include "tasks/equivalent.hpp"

namespace jointid::report {

/// One HTML page: stiffness and damping over displacement, the table.
std::string equivalent_page(const ident::EquivalentScene& scene, const std::vector<tasks::LevelJoint>& levels);

}  // namespace jointid::report

#pragma once

#include <string>

#include "report/text/display.hpp"
#include "tasks/equivalent.hpp"

namespace jointid::report {

/// One HTML page: stiffness and damping over displacement, the table.
std::string equivalent_page(const ident::EquivalentScene& scene, const std::vector<tasks::LevelJoint>& levels,
                            const Display& display = {});

}  // namespace jointid::report

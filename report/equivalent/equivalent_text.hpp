#pragma once

#include <string>

#include "report/text/display.hpp"
#include "report/text/table.hpp"
#include "tasks/equivalent.hpp"

namespace jointid::report {

/// A row for each level.
Table equivalent_table(const std::vector<tasks::LevelJoint>& levels, const Display& display = {});

/// "equivalent stiffness and damping by (7.18), FRFs of the parts made real (7.19)".
std::string equivalent_title(const ident::EquivalentScene& scene);

/// Stiffness and damping by displacement, for people.
std::string equivalent_text(const ident::EquivalentScene& scene, const std::vector<tasks::LevelJoint>& levels,
                            const Display& display = {});

/// The same as JSON; the keys stay. Numbers that are not there are null.
std::string equivalent_json(const ident::EquivalentScene& scene, const std::vector<tasks::LevelJoint>& levels);

/// "displacement [m],stiffness [N/m],damping [N/m],misfit", or in mm and N/mm, what was not found left out.
std::string equivalent_csv(const std::vector<tasks::LevelJoint>& levels, const Display& display = {});

}  // namespace jointid::report

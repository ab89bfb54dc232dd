#pragma once

#include <string>

#include "report/text/table.hpp"
#include "tasks/equivalent.hpp"

namespace jointid::cli {

/// A row for each level.
report::Table equivalent_table(const std::vector<tasks::LevelJoint>& levels);

/// "equivalent stiffness and damping by (7.18), FRFs of the parts made real (7.19)".
std::string equivalent_title(const ident::EquivalentScene& scene);

/// Stiffness and damping by displacement, for people.
std::string equivalent_text(const ident::EquivalentScene& scene, const std::vector<tasks::LevelJoint>& levels);

/// The same as JSON; the keys stay. Numbers that are not there are null.
std::string equivalent_json(const ident::EquivalentScene& scene, const std::vector<tasks::LevelJoint>& levels);

/// "displacement [m],stiffness [N/m],damping [N/m],misfit", what was not found left out.
std::string equivalent_csv(const std::vector<tasks::LevelJoint>& levels);

/// Whether every level has an answer.
bool all_settled(const std::vector<tasks::LevelJoint>& levels);

/// "ok"; "doubtful" where equivalent_doubt() says something; "not_usable" where a level did not settle.
std::string equivalent_status(const std::vector<tasks::LevelJoint>& levels);

/// What speaks against the values by their own errors: a level with no passive joint or an unknown stiffness, or damping that
/// most levels do not tell. Empty: nothing.
std::string equivalent_doubt(const std::vector<tasks::LevelJoint>& levels);

}  // namespace jointid::cli

#pragma once

#include <string>

#include "tasks/joint_history/joint_history.hpp"

namespace jointid::report {

/// The forces of a joint along its history, for people: stiffness, limit, the ends of the parts and what each took.
std::string joint_history_text(const tasks::JointHistoryScene& scene, const tasks::JointHistory& history);
/// The same with all points as JSON; the keys stay.
std::string joint_history_json(const tasks::JointHistoryScene& scene, const tasks::JointHistory& history);
/// Displacement and force of every point, as `loading-curve` reads them; the normal load behind them where it changes.
std::string joint_history_csv(const tasks::JointHistoryScene& scene, const tasks::JointHistory& history);

}  // namespace jointid::report

#pragma once

#include <string>

#include "report/text/table.hpp"
#include "laws/task/identify_laws.hpp"

namespace jointid::report {

/// Laws over AIC, best first.
Table law_table(const laws::LawIdentification& found);
/// Stiffness, limit, range of motion, then parameters of one joint.
Table joint_table(const response::FittedJoint& joint);
/// k_e and d_e of the direct step over the motion of a joint, and those of its law.
Table direct_table(const laws::LawIdentification& found, std::size_t joint);
/// Residuals in standard deviations, level by level.
Table level_table(const laws::LawScene& scene, const laws::LawIdentification& found);

/// All of it for people.
std::string law_text(const laws::LawScene& scene, const laws::LawIdentification& found);

/// Everything. The keys stay; numbers that are not there are null.
std::string law_json(const laws::LawScene& scene, const laws::LawIdentification& found);

/// A line for each unknown, stiffness and limit: "joint,law,quantity,unit,value,std error,ci95 low,ci95 high,knowledge".
std::string law_csv(const laws::LawScene& scene, const laws::LawIdentification& found);

}  // namespace jointid::report

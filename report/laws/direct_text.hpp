#pragma once

#include <string>

#include "laws/task/direct_identification.hpp"
#include "report/text/table.hpp"

namespace jointid::report {

/// k_e and d_e of the direct step over the motion of a joint, and those of a law where there is one.
Table direct_table(const std::vector<response::DirectStep>& steps, std::size_t joint, const response::Joint* law = nullptr);

/// The direct step for people, and as JSON; keys stay.
std::string direct_text(const laws::LawScene& scene, const laws::DirectIdentification& found);
std::string direct_json(const laws::LawScene& scene, const laws::DirectIdentification& found);

/// A line for each state and joint: "joint,level,frequency [Hz],displacement [m],deviation [m],stiffness [N/m],deviation,damping
/// [N/m],deviation". Of one joint it is what `loading-curve` reads.
std::string direct_csv(const laws::LawScene& scene, const laws::DirectIdentification& found);

/// "12 states of 3 levels: 4 lines from 80 to 100 Hz, 2 responses, harmonics 1 3", with an end of line.
std::string states_text(const laws::LawScene& scene, const laws::LevelStates& data);

/// "without any law: χ² = … of …", with an end of line; empty where nothing was tested.
std::string consistency_text(const response::Consistency& test);

}  // namespace jointid::report

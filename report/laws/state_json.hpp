#pragma once

#include <string>
#include <vector>

#include "laws/task/identify_laws.hpp"
#include "report/json_value.hpp"

namespace jointid::report {

/// What solutions and direct steps of friction laws have in common. Keys stay.

/// Level, frequency, harmonics; of every joint F_n, Q_n, F₁/Q₁ and their deviations; separation.
Json state_json(const std::string& level, const response::MeasuredState& measured, const response::DirectStep& step);

/// χ² of the states whatever the laws are, and mistakes that would explain it.
Json consistency_json(const laws::LawScene& scene, const laws::LevelStates& data, const response::Consistency& test);

/// Joints whose even harmonics were measured.
Json even_harmonics_json(const laws::LawScene& scene, const std::vector<laws::OneSidedJoint>& joints);

}  // namespace jointid::report

#pragma once

#include <string>

#include "report/text/table.hpp"
#include "tasks/oscillate/oscillate_result.hpp"

namespace jointid::report {

/// Tables of `oscillate` on the terminal and in its page.
Table fractions_table(const tasks::SeenModes& modes);
Table shapes_table(const tasks::OscillateResult& run);
Table multipliers_table(const oscillation::PeriodicOrbit& orbit);
Table exponents_table(const oscillation::Exponents& exponents, const std::string& unit);
Table reduction_table(const tasks::ReductionTable& reduction);
Table normal_table(const tasks::NormalVibrationResult& result);
Table thick_table(const std::vector<oscillation::ThickMode>& modes);

/// What the scene's [friction] should have for the normal load of slow sliders, in words.
std::string normal_line(const tasks::NormalVibrationResult& result);

/// "s", or "unit of time" of a chain without units.
std::string time_unit(const tasks::OscillateResult& run);
/// One line each: the motion, the orbit, the sweep.
std::string motion_line(const tasks::OscillateResult& run);
std::string orbit_line(const tasks::OscillateResult& run);
std::string sweep_line(const tasks::OscillateResult& run);

/// For people.
std::string oscillate_text(const tasks::OscillateResult& run);
/// The keys stay. Numbers that are not there are null.
std::string oscillate_json(const tasks::OscillateResult& run);
/// A row a sample; the coordinates q1 … of a cantilever last.
std::string motion_csv(const tasks::OscillateResult& run);
/// "parameter,status,value": a row a value.
std::string sweep_csv(const tasks::OscillateResult& run);
/// A row a point of the Poincaré section.
std::string events_csv(const tasks::OscillateResult& run);

}  // namespace jointid::report

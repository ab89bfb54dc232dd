#pragma once

#include <string>

#include "report/oscillate/oscillate_run.hpp"
#include "report/text/table.hpp"

namespace jointid::report {

/// Tables of `oscillate` on the terminal and in its page.
Table fractions_table(const SeenModes& modes);
Table shapes_table(const OscillateRun& run);
Table multipliers_table(const oscillation::PeriodicOrbit& orbit);
Table exponents_table(const oscillation::Exponents& exponents, const std::string& unit);
Table reduction_table(const ReductionTable& reduction);

/// "s", or "unit of time" of a chain without units.
std::string time_unit(const OscillateRun& run);
/// One line each: the motion, the orbit, the sweep.
std::string motion_line(const OscillateRun& run);
std::string orbit_line(const OscillateRun& run);
std::string sweep_line(const OscillateRun& run);

/// For people.
std::string oscillate_text(const OscillateRun& run);
/// The keys stay. Numbers that are not there are null.
std::string oscillate_json(const OscillateRun& run);
/// A row a sample; the coordinates q1 … of a cantilever last.
std::string motion_csv(const OscillateRun& run);
/// "parameter,status,value": a row a value.
std::string sweep_csv(const OscillateRun& run);
/// A row a point of the Poincaré section.
std::string events_csv(const OscillateRun& run);

}  // namespace jointid::report

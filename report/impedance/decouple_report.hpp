#pragma once

#include <string>

#include "impedance/decouple/decouple.hpp"

namespace jointid::report {

/// What was found, and where the FRFs were written.
std::string decouple_text(const impedance::DecoupleScene& scene, const impedance::Decoupled& found, const std::string& file);

/// Everything. The keys stay; numbers that are not there are null.
std::string decouple_json(const impedance::DecoupleScene& scene, const impedance::Decoupled& found, const std::string& file);

/// A line for each way, FRF and frequency.
std::string decouple_csv(const impedance::Decoupled& found);

}  // namespace jointid::report

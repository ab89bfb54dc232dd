#pragma once

#include <string>

#include "tasks/regenerate.hpp"

namespace jointid::report {

/// Magnitudes over frequency of an assembly FRF as measured and as regenerated from the substructures and the identified
/// joint, for a terminal: dB of the receptance against the frequency axis, 72 × 18 characters, with the rms difference.
/// `unit`: of the FRF as it is given.
std::string frf_plot(const tasks::Regenerated& regenerated, const tasks::RegeneratedFrf& frf, const std::string& unit = "m/N");

}  // namespace jointid::report

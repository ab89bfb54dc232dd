#pragma once

#include <string>

#include "ident/result/solution.hpp"
#include "report/text/table.hpp"

namespace jointid::report {

/// Gains, delays and masses that were estimated with the joint, one row each, beside their priors.
Table systematic_table(const std::vector<ident::SystematicEstimate>& systematic);

/// What they have of the variance of every unknown.
Table calibration_table(const std::vector<ident::CalibrationShare>& shares);

/// Both as a section of a solution; empty where nothing of the kind was estimated.
std::string systematic_text(const ident::Solution& solution);

}  // namespace jointid::report

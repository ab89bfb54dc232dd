#pragma once

#include <string>

#include "tasks/couple.hpp"

namespace jointid::cli {

/// The page of a coupling: the conditions and which were left out and why, S and the threshold over the lines, the predicted FRFs
/// with their uncertainty and bounds. Reads FRFs back from the files that coupling wrote.
std::string couple_report(const ident::CoupleScene& scene, const tasks::CoupleResult& result);

}  // namespace jointid::cli

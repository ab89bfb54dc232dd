#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/page/contents.hpp"

namespace jointid::report {

/// The banner of a status: green for "ok", amber for "doubtful" and "suspicious", red for all others (poor_fit, rank_deficient,
/// not_converged, imprecise, …). `status` is the word of the JSON.
StatusBanner status_banner(const std::string& status, const std::string& message, std::vector<std::string> remarks = {},
                           std::vector<SuspectLines> suspects = {});

/// Of trials: green when all are usable, red when none is, and then `none` is its word.
StatusBanner trials_banner(std::size_t usable, std::size_t trials, const std::string& none, const std::string& message);

}  // namespace jointid::report

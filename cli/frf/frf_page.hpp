#pragma once

#include <string>

#include "cli/frf/frf_run.hpp"

namespace jointid::cli {

/// One page: what was averaged, coherences, magnitudes and coherence of the first FRFs over frequency.
std::string frf_report(const FrfRun& run);

}  // namespace jointid::cli

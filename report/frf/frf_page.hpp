#pragma once

#include <string>

#include "tasks/frf/run_frf.hpp"

namespace jointid::report {

/// One page: what was averaged, tasks::coherences, magnitudes and coherence of the first FRFs over frequency.
std::string frf_page(const tasks::FrfRun& run);

}  // namespace jointid::report

#pragma once

#include "report/page/solve_plots.hpp"

namespace jointid::cli::report {

using jointid::report::frf_overlay;
using jointid::report::quality_plots;

}  // namespace jointid::cli::report

#pragma once

#include "report/frf_curves.hpp"

namespace jointid::cli::report {

using jointid::report::drawn_text;
using jointid::report::magnitudes;
using jointid::report::phases_deg;
using jointid::report::receptance_label;

}  // namespace jointid::cli::report

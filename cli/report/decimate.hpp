#pragma once

#include "report/decimate.hpp"

namespace jointid::cli::report {

using jointid::report::keep_peaks;
using jointid::report::picked;

}  // namespace jointid::cli::report

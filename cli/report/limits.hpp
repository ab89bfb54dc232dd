#pragma once

#include "report/page/limits.hpp"

namespace jointid::cli::report {

using jointid::report::most_frfs;
using jointid::report::most_points;
using jointid::report::worst_frfs_drawn;

}  // namespace jointid::cli::report

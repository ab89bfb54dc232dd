#pragma once

#include "report/page/heat_map.hpp"

namespace jointid::cli::report {

using jointid::report::error_map;
using jointid::report::worst_first;
using jointid::report::worst_frfs;

}  // namespace jointid::cli::report

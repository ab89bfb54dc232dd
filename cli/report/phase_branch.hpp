#pragma once

#include "report/page/phase_branch.hpp"

namespace jointid::cli::report {

using jointid::report::choose_branch;

}  // namespace jointid::cli::report

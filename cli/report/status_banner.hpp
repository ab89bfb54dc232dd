#pragma once

#include "report/page/status_banner.hpp"

namespace jointid::cli::report {

using jointid::report::status_banner;

}  // namespace jointid::cli::report

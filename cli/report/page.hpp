#pragma once

#include "cli/report/contents.hpp"
#include "report/page/page.hpp"

namespace jointid::cli::report {

using jointid::report::ReportPage;

}  // namespace jointid::cli::report

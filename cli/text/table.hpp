#pragma once

#include "report/text/table.hpp"

namespace jointid::cli {

using jointid::report::Align;
using jointid::report::Column;
using jointid::report::csv_line;
using jointid::report::csv_number;
using jointid::report::number;
using jointid::report::Table;

}  // namespace jointid::cli

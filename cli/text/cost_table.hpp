#pragma once

#include "report/text/cost_table.hpp"

namespace jointid::cli {

using jointid::report::cost_table;
using jointid::report::CostRow;

}  // namespace jointid::cli

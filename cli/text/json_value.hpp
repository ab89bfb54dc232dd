#pragma once

#include "report/json_value.hpp"

namespace jointid::cli {

using jointid::report::Json;
using jointid::report::json_text;
using jointid::report::value;
using jointid::report::values;

}  // namespace jointid::cli

#pragma once

#include <string>

#include "ident/plan.hpp"

namespace jointid::cli {

/// What a plan will read, compute and leave out, for reading.
std::string plan_text(const ident::Plan& plan);

/// The same as JSON.
std::string plan_json(const ident::Plan& plan);

}  // namespace jointid::cli

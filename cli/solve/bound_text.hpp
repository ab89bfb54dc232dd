#pragma once

#include <string>

#include "ident/tasks/bound_report.hpp"

namespace jointid::cli {

/// The tables of `jointid plan --bound`.
std::string bound_text(const ident::BoundReport& report);

}  // namespace jointid::cli

#pragma once

#include <string>

#include "ident/result/suspect.hpp"

namespace jointid::report {

/// The verdict, a table of the suspects, and below it the evidence and the scene's lines that would mend each.
std::string check_text(const ident::CheckResult& result);

}  // namespace jointid::report

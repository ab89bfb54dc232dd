#pragma once

#include <nlohmann/json_fwd.hpp>

#include "ident/result/suspect.hpp"

namespace jointid::report {

/// {"verdict", "suspects": [{"kind", "file", "dofs", "evidence", "confidence", "remedy"}]}; "remedy" is null where there is none.
nlohmann::ordered_json check_json(const ident::CheckResult& result);

}  // namespace jointid::report

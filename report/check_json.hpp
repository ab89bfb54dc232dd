#pragma once

#include <nlohmann/json_fwd.hpp>

#include "ident/result/suspect.hpp"

namespace jointid::report {

/// {"verdict", "suspects": [{"kind", "file", "dofs", "evidence", "confidence", "remedy"}]}; "remedy" is null where there is none.
/// Where there are any: "notes", sentences; "reciprocity": [{"file", "rms", "dofs", "map"}], ReciprocityMap to three decimals.
nlohmann::ordered_json check_json(const ident::CheckResult& result);

}  // namespace jointid::report

#pragma once

#include "ident/result/solution.hpp"
#include "report/json_value.hpp"

namespace jointid::report {

/// The solution of which solution_json() wrote this: what is null there is NaN or empty. Not in the JSON, hence not here: errors
/// of matrix elements, Identifiability::stiff_pairs, the reasons of Suspect beside its text. Throws InputError (data) that names
/// the key.
ident::Solution solution_of_json(const Json& json);

/// NaN of null.
double number_of(const Json& json);

/// Of its key, "stiffness"; throws InputError (usage).
restrictions::Kind matrix_kind(const std::string& key);

}  // namespace jointid::report

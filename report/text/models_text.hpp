#pragma once

#include <string>
#include <vector>

#include "ident/result/used_model.hpp"

namespace jointid::report {

/// A table of the files that are models, with an empty line before it: how their FRFs will be computed, and what that takes.
/// Empty where there is none.
std::string planned_models_text(const std::vector<ident::UsedModel>& models);

/// The same of how they were computed.
std::string used_models_text(const std::vector<ident::UsedModel>& models);

}  // namespace jointid::report

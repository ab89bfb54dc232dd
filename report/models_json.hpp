#pragma once

#include <vector>

#include "ident/result/used_model.hpp"
#include "report/json_value.hpp"

namespace jointid::report {

/// [{"file", "way", "coordinates", …}]: how the FRFs of models were computed (docs/model-parts.md); `planned`: how they will be.
Json models_json(const std::vector<ident::UsedModel>& models, bool planned);

/// From what models_json() wrote of a result.
std::vector<ident::UsedModel> models_of_json(const Json& json);

}  // namespace jointid::report

#pragma once

#include <string>

#include "tasks/couple.hpp"

namespace jointid::cli {

/// What coupling did, as JSON; the keys stay. Numbers that are not there are null.
std::string couple_json(const ident::CoupleScene& scene, const tasks::CoupleResult& result);

}  // namespace jointid::cli

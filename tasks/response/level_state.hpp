#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tasks/response/response_result.hpp"

namespace jointid::tasks {

/// Levels as bytes and back, to the last bit: what an interrupted run keeps of them. Bytes of the same version on the same kind of
/// processor; no value where they are not such.
std::string packed_levels(LevelsSoFar levels);
std::optional<LevelsSoFar> unpacked_levels(std::string_view bytes);

}  // namespace jointid::tasks

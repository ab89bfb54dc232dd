#pragma once

#include <cstdint>
#include <optional>

#include "laws/task/assumed_states.hpp"

namespace jointid::laws {

/// The levels as one test would measure them: the true FRFs of the parts are drawn about those of the files, by the files'
/// variances, harmonic balance of the assumed laws is solved over them, and the phasors of responses and forces are drawn about
/// these states, by their deviations. Depends on the seed and the trial alone. None where the drawn parts have no response.
std::optional<LevelStates> simulated_levels(const AssumedStates& assumed, std::uint64_t seed, std::size_t trial);

}  // namespace jointid::laws

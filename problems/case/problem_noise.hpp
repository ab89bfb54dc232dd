#pragma once

#include <variant>

#include "base/random.hpp"
#include "frf/noise/noise.hpp"
#include "frf/set/frf_set.hpp"
#include "problems/structure/modes.hpp"

namespace jointid::problems {

/// The errors a case is defined with: of the FRFs, or of the modes from which they are regenerated.
using ProblemNoise = std::variant<frf::NoiseModel, ConsistentErrors>;

/// A set with the errors of a case; `exact` are the modes of its structure.
frf::FrfSet with_noise(const frf::FrfSet& clean, const Modes& exact, const ProblemNoise& noise, const RandomStream& stream);

}  // namespace jointid::problems

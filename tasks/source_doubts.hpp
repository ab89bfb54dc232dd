#pragma once

#include <string>
#include <vector>

#include "frf/set/frf_source.hpp"

namespace jointid::tasks {

/// What speaks against the FRFs of a source, one sentence each: what its reader doubts, and driving points that are not passive
/// (frf::TurnedPoints, of at most 64 lines that are evenly spread).
std::vector<std::string> source_doubts(frf::FrfSource& source);

}  // namespace jointid::tasks

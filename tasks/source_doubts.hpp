#pragma once

#include <string>
#include <vector>

#include "frf/set/frf_source.hpp"

namespace jointid::tasks {

/// What speaks against the FRFs of a source, one sentence each: what its reader doubts, and of measured ones driving points that are
/// not passive (frf::TurnedPoints). For these the first 32 DOFs that are response and reference are read, on at most 64 lines that
/// are evenly spread.
std::vector<std::string> source_doubts(frf::FrfSource& source);

}  // namespace jointid::tasks

#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "frf/set/frf_source.hpp"

namespace jointid::tasks {

struct ProposedRange {
  std::optional<std::array<double, 2>> range_hz;  ///< empty where all lines are taken
  std::vector<std::string> reasons;
};

/// The frequencies that all files have, without 0 Hz; where files know coherences or variances, without the ends at which the
/// median over FRFs says that noise rules: a coherence below 0.5, or a standard deviation above half of |H|. At most `most_lines`
/// lines and 64 FRFs of a file are looked at. Throws InputError (data) where the files have no frequencies in common, and
/// Interrupted.
ProposedRange propose_range(const std::vector<frf::FrfSource*>& files, const std::function<bool()>& interrupted = {},
                            std::size_t most_lines = 200);

}  // namespace jointid::tasks

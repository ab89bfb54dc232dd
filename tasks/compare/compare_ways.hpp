#pragma once

#include <functional>
#include <string>

#include "study/comparison.hpp"

namespace jointid::tasks {

/// Ways of identifying compared by error and time on the same trials: what `jointid compare` finds.
struct ComparisonResult {
  std::string title;  ///< of the scene
  std::size_t trials = 0;
  std::uint64_t seed = 0;
  study::Comparison comparison;  ///< errors are relative, times in s
};

/// Compares every combination of `alternatives` (those of the scene where a list is empty) on the files of the scene with
/// simulated noise. `so_far` is given what there is after every way, its fronts not marked (study::mark_fronts()). Throws
/// InputError as study::compare(), and Interrupted.
ComparisonResult compare_ways(const ident::Scene& scene, const study::Alternatives& alternatives,
                              const study::TrialOptions& options,
                              const std::function<void(const ComparisonResult&)>& so_far = {});

/// The same on FRFs in memory, as the scene's [data] lists them, with the noise of its [noise], or that which
/// the sets record.
ComparisonResult compare_ways(const ident::Scene& scene, const study::Measurements& sets, const study::Alternatives& alternatives,
                              const study::TrialOptions& options,
                              const std::function<void(const ComparisonResult&)>& so_far = {});

/// Whether some way gave an estimate in some trial.
bool some_usable(const ComparisonResult& result);

}  // namespace jointid::tasks

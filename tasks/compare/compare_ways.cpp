#include "tasks/compare/compare_ways.hpp"

#include <algorithm>

#include "study/trial_data.hpp"

namespace jointid::tasks {
namespace {

ComparisonResult compared(const ident::Scene& scene, const study::TrialSource& source, const study::Alternatives& alternatives,
                          const study::TrialOptions& options, const std::function<void(const ComparisonResult&)>& so_far) {
  const auto result_of = [&](study::Comparison comparison) {
    return ComparisonResult{scene.title, options.trials, options.seed, std::move(comparison)};
  };
  std::function<void(const study::Comparison&)> keep;
  if (so_far) keep = [&](const study::Comparison& comparison) { so_far(result_of(comparison)); };
  const auto ways = study::combinations(scene.identify, alternatives, scene.data.regenerate);
  return result_of(study::compare(scene, ways, source, options, keep));
}

}  // namespace

ComparisonResult compare_ways(const ident::Scene& scene, const study::Alternatives& alternatives,
                              const study::TrialOptions& options, const std::function<void(const ComparisonResult&)>& so_far) {
  return compared(scene, study::load_trial_data, alternatives, options, so_far);
}

ComparisonResult compare_ways(const ident::Scene& scene, const study::Measurements& sets, const study::Alternatives& alternatives,
                              const study::TrialOptions& options, const std::function<void(const ComparisonResult&)>& so_far) {
  const auto source = [&](const ident::Scene& each) { return study::make_trial_data(each, sets); };
  return compared(scene, source, alternatives, options, so_far);
}

bool some_usable(const ComparisonResult& result) {
  const auto usable = [](const auto& status) { return ident::is_usable(status.first); };
  return std::ranges::any_of(result.comparison.combinations,
                             [&](const auto& each) { return std::ranges::any_of(each.statuses, usable); });
}

}  // namespace jointid::tasks

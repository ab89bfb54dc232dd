#include "gui/compare/compare_job.hpp"

#include "base/control.hpp"
#include "study/trial_data.hpp"

namespace jointid::gui {

study::Comparison run_comparison(const ComparisonWish& wish, const Worker::Watch& watch,
                                 const std::function<void(const study::Comparison&)>& so_far) {
  study::TrialOptions options{.trials = wish.trials, .seed = wish.seed};
  options.interrupted = watch.interrupted;
  options.progress = [&](std::size_t done, std::size_t total) { watch.progress("trials", done, total); };
  study::Comparison last;
  const auto keep = [&](study::Comparison comparison) {
    study::mark_fronts(comparison.combinations);
    so_far(comparison);
    last = std::move(comparison);
  };
  const auto ways = study::combinations(wish.scene.identify, wish.alternatives, wish.scene.data.regenerate);
  try {
    return study::compare(wish.scene, ways, study::load_trial_data, options, keep);
  } catch (const Interrupted&) {
    if (last.combinations.empty()) throw;
    last.interrupted = true;
    return last;
  }
}

}  // namespace jointid::gui

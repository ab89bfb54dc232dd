#include "gui/compare/compare_job.hpp"

#include "base/control.hpp"
#include "ident/study/trial_data.hpp"

namespace jointid::gui {

ident::Comparison run_comparison(const ComparisonWish& wish, const Worker::Watch& watch,
                                 const std::function<void(const ident::Comparison&)>& so_far) {
  ident::TrialOptions options{.trials = wish.trials, .seed = wish.seed};
  options.interrupted = watch.interrupted;
  options.progress = [&](std::size_t done, std::size_t total) { watch.progress("trials", done, total); };
  ident::Comparison last;
  const auto keep = [&](ident::Comparison comparison) {
    ident::mark_fronts(comparison.combinations);
    so_far(comparison);
    last = std::move(comparison);
  };
  const auto ways = ident::combinations(wish.scene.identify, wish.alternatives, wish.scene.data.regenerate);
  try {
    return ident::compare(wish.scene, ways, ident::load_trial_data, options, keep);
  } catch (const Interrupted&) {
    if (last.combinations.empty()) throw;
    last.interrupted = true;
    return last;
  }
}

}  // namespace jointid::gui

#include "gui/compare/compare_job.hpp"

#include "base/control.hpp"
#include "tasks/compare/compare_ways.hpp"

namespace jointid::gui {

study::Comparison run_comparison(const ComparisonWish& wish, const Worker::Watch& watch,
                                 const std::function<void(const study::Comparison&)>& so_far) {
  watch.begin({});
  study::TrialOptions options{.trials = wish.trials, .seed = wish.seed};
  options.interrupted = watch.interrupted;
  options.progress = [&](std::size_t done, std::size_t total) { watch.progress("trials", done, total); };
  study::Comparison last;
  const auto keep = [&](const tasks::ComparisonResult& result) {
    last = result.comparison;
    study::mark_fronts(last.combinations);
    so_far(last);
  };
  try {
    return tasks::compare_ways(wish.scene, wish.alternatives, options, keep).comparison;
  } catch (const Interrupted&) {
    if (last.combinations.empty()) throw;
    last.interrupted = true;
    return last;
  }
}

}  // namespace jointid::gui

#include "gui/study/study_job.hpp"

#include <algorithm>
#include <limits>

#include "base/control.hpp"
#include "base/stopwatch.hpp"
#include "gui/look/said.hpp"
#include "report/result/study_plots.hpp"
#include "report/result/study_tables.hpp"
#include "study/trial_data.hpp"
#include "tasks/study/run_study.hpp"
#include "tasks/study/trial_histograms.hpp"

namespace jointid::gui {
namespace {

constexpr double seconds_between_pictures = 0.3;
constexpr std::size_t most_unknowns_drawn = 300;

void add_choices(report::PlotGroup group, std::vector<HistogramSet>& out) {
  for (report::Choice& choice : group.choices) {
    HistogramSet set{choice.name, {}};
    for (report::Plot& plot : choice.plots) set.plots.push_back(std::get<report::HistogramPlot>(std::move(plot)));
    out.push_back(std::move(set));
  }
}

StudyShown whole(const study::StudyOptions& options, const tasks::StudyResult& result) {
  const study::StudyStatistics& statistics = result.statistics;
  const tasks::StudyHistograms histograms = tasks::study_histograms(options.out, statistics, most_unknowns_drawn);
  StudyShown shown{.complete = true, .done = result.run.done, .trials = options.trials};
  add_choices(report::study_unknown_plots(histograms.unknowns, statistics, most_unknowns_drawn), shown.histograms);
  add_choices(report::study_quality_plots(histograms.quality, statistics), shown.histograms);
  shown.unknowns = report::unknowns_table(statistics);
  shown.text = Said::tr("trials: ").toStdString() + report::trials_text(statistics) + "\n" + report::speed_text(result.run);
  return shown;
}

study::StudyOptions options_of(const StudyWish& wish) {
  study::StudyOptions options;
  options.trials = wish.trials;
  options.seed = wish.seed;
  options.out = wish.out;
  options.resume = !wish.from_the_beginning && std::filesystem::exists(study::journal_path(wish.out));
  options.texts = tasks::study_texts(wish.scene_text);
  return options;
}

}  // namespace

LiveTrials::LiveTrials(const std::vector<study::TrialUnknown>& unknowns) : unknowns_(unknowns) {
  unknowns_.resize(std::min(most_unknowns, unknowns_.size()));
  values_.resize(unknowns_.size());
}

/// Trials without an estimate have NaN there, which histograms leave out.
void LiveTrials::put(std::span<const double> row) {
  const std::lock_guard lock(mutex_);
  for (std::size_t i = 0; i < unknowns_.size() && values_[i].size() < most_trials; ++i) values_[i].push_back(row[1 + i]);
}

std::vector<HistogramSet> LiveTrials::histograms() const {
  const std::lock_guard lock(mutex_);
  HistogramSet set{Said::tr("so far").toStdString(), {}};
  for (std::size_t i = 0; i < unknowns_.size(); ++i) {
    if (const auto histogram = tasks::histogram_of(unknowns_[i].name, unknowns_[i].unit, values_[i], unknowns_[i].truth))
      set.plots.push_back(report::histogram_plot(*histogram));
  }
  return set.plots.empty() ? std::vector<HistogramSet>() : std::vector{std::move(set)};
}

StudyShown run_study_job(const StudyWish& wish, const Worker::Watch& watch,
                         const std::function<void(const StudyShown&)>& so_far) {
  const study::StudyOptions options = options_of(wish);
  watch.begin({1, 2, 0.0, 0.05});
  watch.progress("reading", 0, 0);
  const auto data = study::load_trial_data(wish.scene);
  stop_if(watch.interrupted);
  watch.begin({2, 2, 0.05, 1.0});
  LiveTrials live(data->unknowns);
  auto shown_at = Clock::now();
  study::StudyControl control;
  control.interrupted = watch.interrupted;
  control.row = [&](std::size_t, std::span<const double> row) { live.put(row); };
  control.progress = [&](std::size_t done, std::size_t total) {
    watch.progress("trials", done, total);
    if (seconds_since(shown_at) < seconds_between_pictures) return;
    so_far({.done = done, .trials = total, .histograms = live.histograms()});
    shown_at = Clock::now();
  };
  const auto team = ident::join_team();
  const tasks::StudyResult result = tasks::run_study(data, options, *team, control);
  if (result.run.complete) return whole(options, result);
  return {.done = result.run.done, .trials = options.trials, .histograms = live.histograms()};
}

}  // namespace jointid::gui

#include "report/result/study_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/page/contents.hpp"
#include "report/page/page.hpp"
#include "report/page/status_banner.hpp"
#include "report/result/study_plots.hpp"
#include "report/result/study_tables.hpp"
#include "report/text/noise_text.hpp"
#include "report/text/words.hpp"

namespace jointid::report {
namespace {

void add_summary(const tasks::StudyResult& result, const ident::Scene& scene, ReportPage& page) {
  const ident::IdentifySection& identify = scene.identify;
  page.section("Summary");
  page.add(Facts{{{"trials", trials_text(result.statistics)},
                  {"seed", fmt::format("{}", result.seed)},
                  {"noise", noise_text(scene.noise)},
                  {"method", ident::name(identify.method)},
                  {"equations", equations_text(identify.equations)},
                  {"weighting", weighting_text(identify.method, identify.weighting)},
                  {"delta", delta_text(identify.method, identify.delta)},
                  {"solver", name(identify.solver)},
                  {"all results", result.file}}});
  for (const std::string& note : result.notes) page.add(Text{note});
  page.add(Text{speed_text(result.run) + ".", true});
}

void add_unknowns(const tasks::StudyResult& result, const std::vector<tasks::TrialHistogram>& histograms, ReportPage& page) {
  study::StudyStatistics shown = result.statistics;
  const std::size_t all = shown.unknowns.size();
  shown.unknowns.resize(std::min(most_unknowns_shown, all));
  page.section("Unknowns");
  page.add(unknowns_table(shown));
  page.add(
      Text{"Bias, standard deviation, rms error and quantiles of the error are in percent of the true value, or of the mean "
           "where none is known.",
           true});
  if (std::ranges::any_of(shown.unknowns, [](const auto& unknown) { return unknown.coverage.has_value(); })) {
    page.add(Text{"Coverage: share of the 95 % intervals that hold the truth.", true});
  }
  if (all > most_unknowns_shown) {
    page.add(Text{
        fmt::format("First {} of {} unknowns; --json, --csv and {} have all of them.", most_unknowns_shown, all, result.file)});
  }
  page.add(study_unknown_plots(histograms, result.statistics, most_unknowns_shown));
}

void add_quality(const tasks::StudyResult& result, const std::vector<tasks::TrialHistogram>& histograms, ReportPage& page) {
  if (result.statistics.quality.empty()) return;
  page.section("Against the truth");
  page.add(quality_table(result.statistics.quality));
  page.add(study_quality_plots(histograms, result.statistics));
}

/// Not green where a solution does not tell a matrix, though every trial gave one.
StatusBanner banner_of(const study::StudyStatistics& statistics) {
  const std::string trials = trials_text(statistics) + ".", doubt = tasks::study_doubt(statistics);
  if (statistics.usable == statistics.trials && !doubt.empty()) return status_banner("doubtful", doubt + ". " + trials);
  return trials_banner(statistics.usable, statistics.trials, "no trial gave an estimate", trials);
}

}  // namespace

std::string study_page(const tasks::StudyResult& result, const ident::Scene& scene, const tasks::StudyHistograms& histograms) {
  const std::string file = scene.file.filename().string();
  ReportPage page(scene.title.empty() ? file : scene.title, "jointid study " + file);
  page.status(banner_of(result.statistics));
  add_summary(result, scene, page);
  add_unknowns(result, histograms.unknowns, page);
  add_quality(result, histograms.quality, page);
  return page.html();
}

}  // namespace jointid::report

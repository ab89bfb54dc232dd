#include "cli/study/study_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/text/noise_text.hpp"
#include "report/page/contents.hpp"
#include "report/page/page.hpp"
#include "report/page/status_banner.hpp"
#include "report/result/study_plots.hpp"
#include "report/result/study_tables.hpp"
#include "report/text/words.hpp"

namespace jointid::cli {
namespace {

using report::quality_histograms;
using report::quality_table;
using report::speed_text;
using report::trials_text;
using report::unknown_histograms;
using report::unknowns_table;

/// More is no reading matter; the JSON and the result file have it.
constexpr std::size_t most_unknowns = 300;

void add_summary(const StudyReport& report, const ident::Scene& scene, report::ReportPage& page) {
  const ident::IdentifySection& identify = scene.identify;
  page.section("Summary");
  page.add(report::Facts{{{"trials", trials_text(report.statistics)},
                          {"seed", fmt::format("{}", report.seed)},
                          {"noise", noise_text(scene.noise)},
                          {"method", ident::name(identify.method)},
                          {"equations", report::equations_text(identify.equations)},
                          {"weighting", report::weighting_text(identify.method, identify.weighting)},
                          {"delta", report::delta_text(identify.method, identify.delta)},
                          {"solver", identify.solver},
                          {"all results", report.file}}});
  for (const std::string& note : report.notes) page.add(report::Text{note});
  page.add(report::Text{speed_text(report.run) + ".", true});
}

void add_unknowns(const StudyReport& report, report::ReportPage& page) {
  study::StudyStatistics shown = report.statistics;
  const std::size_t all = shown.unknowns.size();
  shown.unknowns.resize(std::min(most_unknowns, all));
  page.section("Unknowns");
  page.add(unknowns_table(shown));
  page.add(report::Text{
      "Bias, standard deviation, rms error and quantiles of the error are in percent of the true value, or of the mean "
      "where none is known.",
      true});
  if (std::ranges::any_of(shown.unknowns, [](const auto& unknown) { return unknown.coverage.has_value(); })) {
    page.add(report::Text{"Coverage: share of the 95 % intervals that hold the truth.", true});
  }
  if (all > most_unknowns) {
    page.add(report::Text{
        fmt::format("First {} of {} unknowns; --json, --csv and {} have all of them.", most_unknowns, all, report.file)});
  }
  page.add(unknown_histograms(report.file, report.statistics, most_unknowns));
}

void add_quality(const StudyReport& report, report::ReportPage& page) {
  if (report.statistics.quality.empty()) return;
  page.section("Against the truth");
  page.add(quality_table(report.statistics.quality));
  page.add(quality_histograms(report.file, report.statistics));
}

/// Not green where a solution does not tell a matrix, though every trial gave one.
report::StatusBanner banner_of(const study::StudyStatistics& statistics) {
  const std::string trials = trials_text(statistics) + ".", doubt = report::study_doubt(statistics);
  if (statistics.usable == statistics.trials && !doubt.empty()) return report::status_banner("doubtful", doubt + ". " + trials);
  return report::trials_banner(statistics.usable, statistics.trials, "no trial gave an estimate", trials);
}

}  // namespace

std::string study_report(const StudyReport& report, const ident::Scene& scene) {
  const std::string file = scene.file.filename().string();
  report::ReportPage page(scene.title.empty() ? file : scene.title, "jointid study " + file);
  page.status(banner_of(report.statistics));
  add_summary(report, scene, page);
  add_unknowns(report, page);
  add_quality(report, page);
  return page.html();
}

}  // namespace jointid::cli

#include "report/laws/law_study_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "laws/task/identify_laws.hpp"
#include "report/laws/law_study_text.hpp"
#include "report/page/page.hpp"
#include "report/page/status_banner.hpp"

namespace jointid::report {
namespace {

HistogramPlot histogram(const laws::StudiedValue& value) {
  constexpr double least_bins = 8.0, most_bins = 40.0, margin = 0.05;
  const auto [least, most] = std::ranges::minmax(value.found);
  const double low = std::min(least, value.truth), high = std::max(most, value.truth), beside = margin * (high - low);
  HistogramPlot plot;
  plot.title = value.joint + ": " + value.name;
  plot.x = {value.unit.empty() ? value.name : value.name + " (" + value.unit + ")", false};
  plot.low = low - beside, plot.high = high + beside;
  const double bins = std::clamp(std::round(std::sqrt(static_cast<double>(value.found.size()))), least_bins, most_bins);
  plot.counts.assign(static_cast<std::size_t>(bins), 0.0);
  for (const double each : value.found)
    ++plot.counts[static_cast<std::size_t>(bins * (each - plot.low) / (plot.high - plot.low))];
  plot.mark = value.truth;
  plot.mark_name = "truth";
  return plot;
}

/// Whether a diagram says more than the table.
bool varies(const laws::StudiedValue& value) {
  return std::isfinite(value.truth) && value.found.size() > 1 && std::ranges::min(value.found) < std::ranges::max(value.found);
}

}  // namespace

PlotGroup law_study_plots(const laws::LawStudy& study) {
  PlotGroup group{"joint", {}};
  for (const laws::StudiedValue& value : study.values) {
    if (!varies(value)) continue;
    if (group.choices.empty() || group.choices.back().name != value.joint) group.choices.push_back({value.joint, {}});
    group.choices.back().plots.emplace_back(histogram(value));
  }
  return group;
}

std::string law_study_page(const laws::LawScene& scene, const laws::LawStudy& study) {
  ReportPage page(scene.title.empty() ? "Friction laws from vibration: a study" : scene.title, "jointid study");
  page.status(trials_banner(study.usable, study.trials, "no trial gave usable laws",
                            fmt::format("{} of {} trials gave usable laws.", study.usable, study.trials)));
  page.section("Summary");
  page.add(Text{law_study_summary(study)});
  for (const std::string& note : study.notes) page.add(Text{note, true});
  page.section("Errors and intervals");
  page.add(law_values_table(study));
  page.add(
      Text{"Of the trials whose laws are the true ones. Bound: the least deviation that any unbiased estimate can have; "
           "coverage: share of the 95 % intervals that hold the truth.",
           true});
  page.add(law_study_plots(study));
  return page.html();
}

}  // namespace jointid::report

#include "report/series/align_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/statistics.hpp"
#include "report/json_value.hpp"
#include "report/page/page.hpp"
#include "report/page/status_banner.hpp"
#include "report/text/notes.hpp"

namespace jointid::report {
namespace {

double degrees(const tasks::AlignResult& report, const tasks::LateChannel& channel) {
  return 360.0 * report.task.frequency_hz * channel.delay;
}

/// Three periods in the middle of every channel over its amplitude.
template <class Samples>
CurvePlot periods_plot(const tasks::AlignResult& report, const std::string& title, const Samples& samples_of) {
  constexpr double periods = 3.0;
  constexpr std::size_t most_channels = 12, least_samples = 2;
  const std::size_t there = report.record.samples.front().size();
  const auto wanted = static_cast<std::size_t>(periods * report.record.rate_hz / report.task.frequency_hz);
  const std::size_t samples = std::min(there, std::max(least_samples, wanted)), first = (there - samples) / 2;
  CurvePlot plot;
  plot.title = title;
  plot.x = {"time (s)", false};
  plot.y = {"over the amplitude", false};
  for (std::size_t i = first; i < first + samples; ++i) plot.x_values.push_back(static_cast<double>(i) / report.record.rate_hz);
  for (std::size_t k = 0; k < std::min(most_channels, report.channels.size()); ++k) {
    Series curve{report.channels[k].name, {}, Style::line};
    const std::vector<double>& x = samples_of(k);
    for (std::size_t i = first; i < first + samples; ++i) curve.y.push_back(x[i] / report.channels[k].amplitude);
    plot.series.push_back(std::move(curve));
  }
  return plot;
}

}  // namespace

std::vector<std::string> align_remarks(const tasks::AlignResult& report) {
  constexpr double much = 0.5;
  std::vector<std::string> out;
  for (const tasks::LateChannel& channel : report.channels) {
    if (channel.amplitude == 0.0) {
      out.push_back(channel.name + " does not move at this frequency");
    } else if (!(channel.rest <= much)) {
      out.push_back(fmt::format("{}: {:.0f} % of its rms are of no harmonic of {} Hz: is the frequency right, the motion steady?",
                                channel.name, 100.0 * channel.rest, number(report.task.frequency_hz)));
    }
  }
  return out;
}

Table delays_table(const tasks::AlignResult& report) {
  Table table({{"channel", Align::left}, {"amplitude"}, {"late by s"}, {"degrees"}});
  for (const tasks::LateChannel& each : report.channels)
    table.add({each.name, number(each.amplitude), number(each.delay), fmt::format("{:.3f}", degrees(report, each))});
  return table;
}

PlotGroup align_plots(const tasks::AlignResult& report) {
  const auto measured = [&](std::size_t k) -> const std::vector<double>& { return report.record.samples[k]; };
  return {"", {{"", {periods_plot(report, "As measured", measured), periods_plot(report, "Aligned", [&](std::size_t k) {
                       return aligned(report, k);
                     })}}}};
}

std::string align_summary(const tasks::AlignResult& report) {
  const tasks::LateChannel& most =
      *std::ranges::max_element(report.channels, {}, [](const tasks::LateChannel& each) { return std::abs(each.delay); });
  return fmt::format("{} is {} s {} against {}, the most of {} channels.", most.name, number(std::abs(most.delay)),
                     most.delay < 0.0 ? "early" : "late", report.task.reference, report.channels.size());
}

std::string align_text(const tasks::AlignResult& report) {
  std::string text;
  text += notes_text(align_remarks(report));
  return text +
         fmt::format(
             "against {} at {} Hz; a delay is known up to whole periods, and holds the phase that the motion itself has "
             "between the places\n",
             report.task.reference, number(report.task.frequency_hz)) +
         delays_table(report).text();
}

std::string align_json(const tasks::AlignResult& report) {
  Json out = {{"status", "ok"},
              {"reference", report.task.reference},
              {"frequency_hz", value(report.task.frequency_hz)},
              {"channels", Json::array()},
              {"remarks", align_remarks(report)}};
  for (const tasks::LateChannel& each : report.channels) {
    out["channels"].push_back({{"name", each.name},
                               {"amplitude", value(each.amplitude)},
                               {"delay_s", value(each.delay)},
                               {"degrees", value(degrees(report, each))},
                               {"rest", value(each.rest)}});
  }
  return json_text(out);
}

std::string align_csv(const tasks::AlignResult& report) {
  std::vector<std::string> row = {"time [s]"};
  std::vector<std::vector<double>> channels;
  for (std::size_t k = 0; k < report.channels.size(); ++k) {
    const auto& [name, unit] = report.record.channels[k];
    row.push_back(unit.empty() ? name : name + " [" + unit + "]");
    channels.push_back(aligned(report, k));
  }
  std::string text = csv_line(row);
  for (std::size_t i = 0; i < channels.front().size(); ++i) {
    row = {csv_number(static_cast<double>(i) / report.record.rate_hz)};
    for (const std::vector<double>& channel : channels) row.push_back(csv_number(channel[i]));
    text += csv_line(row);
  }
  return text;
}

std::string align_page(const tasks::AlignResult& report) {
  ReportPage page(report.record.file, "jointid series align");
  const std::vector<std::string> remarks = align_remarks(report);
  page.status(status_banner(remarks.empty() ? "ok" : "doubtful", align_summary(report), remarks));
  page.section("Delays");
  page.add(delays_table(report));
  page.add(
      Text{"A delay is known up to whole periods, and holds the phase that the motion itself has between the places.", true});
  page.section("Channels");
  page.add(align_plots(report));
  return page.html();
}

}  // namespace jointid::report

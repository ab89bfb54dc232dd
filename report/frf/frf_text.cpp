#include "report/frf/frf_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/statistics.hpp"
#include "frf/noise/turned_points.hpp"
#include "report/text/table.hpp"

namespace jointid::report {
namespace {

constexpr std::size_t most_stretches = 40;

std::string coherence_number(double value) { return std::isfinite(value) ? fmt::format("{:.4f}", value) : "–"; }

}  // namespace

Table stretches_table(const tasks::FrfRun& run) {
  Table table({{run.options.segments ? "segment" : "hit"},
               {"file", Align::left},
               {"from s"},
               {run.options.segments ? "rms force N" : "peak force N"},
               {"", Align::left}});
  const auto& blows = run.made.blows;
  for (std::size_t i = 0; i < blows.size(); ++i) {
    const records::Blow& blow = blows[i];
    if (blow.rejected.empty() && blows.size() > most_stretches) continue;
    table.add({fmt::format("{}", i + 1), run.record_files[blow.record], fmt::format("{:.4f}", tasks::begin_s(run, blow)),
               fmt::format("{:.4g}", blow.force), blow.rejected.empty() ? "kept" : "rejected: " + blow.rejected});
  }
  return table;
}

Table averages_table(const tasks::FrfRun& run) {
  Table table({{"reference", Align::left}, {"kept"}, {"of"}, {"averages"}});
  for (const records::Averages& of : run.made.averages) {
    table.add(
        {of.reference.name(), fmt::format("{}", of.kept), fmt::format("{}", of.found), fmt::format("{:.4g}", of.effective)});
  }
  return table;
}

Table coherence_table(const tasks::FrfRun& run) {
  Table table({{"FRF", Align::left}, {"coherence: 5 %"}, {"median"}, {"95 % of lines"}});
  const frf::FrfHeader& header = run.made.set.header;
  for (std::size_t c = 0; c < header.reference.size(); ++c) {
    for (std::size_t r = 0; r < header.response.size(); ++r) {
      const Spread of = spread(tasks::coherences(run, r, c));
      table.add({header.response[r].name() + " / " + header.reference[c].name(), coherence_number(of.low),
                 coherence_number(of.median), coherence_number(of.high)});
    }
  }
  return table;
}

std::string estimate_text(const tasks::FrfRun& run) {
  const std::vector<double>& hz = run.made.set.header.frequency_hz;
  return fmt::format("{}, {} lines from {:g} to {:g} Hz{}", records::name(run.options.estimator), hz.size(), hz.front(),
                     hz.back(), hz.size() > 1 ? fmt::format(", step {:g} Hz", hz[1] - hz[0]) : "");
}

std::vector<std::string> notes(const tasks::FrfRun& run) {
  std::vector<std::string> out = run.delays;
  const std::size_t responses = run.made.set.header.response.size();
  for (const records::Averages& of : run.made.averages) {
    if (of.kept == 1) out.push_back("One average at " + of.reference.name() + ": it has no coherence, variances or covariances.");
    if (of.kept > run.forces && responses > 1 && of.kept - run.forces < responses) {
      out.push_back(
          fmt::format("{} averages at {} of {} responses: their covariances have rank {} and cannot be inverted as they are.",
                      of.kept, of.reference.name(), responses, of.kept - run.forces));
    }
  }
  frf::TurnedPoints turned(run.made.set.header);
  turned.add(run.made.set.values);
  if (std::string text = frf::turned_points_text(turned.found()); !text.empty()) out.push_back(std::move(text));
  return out;
}

std::string frf_text(const tasks::FrfRun& run) {
  std::string text;
  const auto& blows = run.made.blows;
  if (blows.size() > most_stretches) {
    const auto kept = std::ranges::count_if(blows, [](const records::Blow& blow) { return blow.rejected.empty(); });
    text += fmt::format("{} of {} kept; left out:\n", kept, blows.size());
  }
  text +=
      stretches_table(run).text() + averages_table(run).text() + coherence_table(run).text() + "  " + estimate_text(run) + "\n";
  for (const std::string& note : notes(run)) text += "  note: " + note + "\n";
  return text;
}

std::string stretches_csv(const tasks::FrfRun& run) {
  std::string csv = csv_line({"number", "file", "from_s", "force_n", "kept", "reason"});
  const auto& blows = run.made.blows;
  for (std::size_t i = 0; i < blows.size(); ++i) {
    csv += csv_line({fmt::format("{}", i + 1), run.record_files[blows[i].record], csv_number(tasks::begin_s(run, blows[i])),
                     csv_number(blows[i].force), blows[i].rejected.empty() ? "true" : "false", blows[i].rejected});
  }
  return csv;
}

}  // namespace jointid::report

#include "cli/frf/frf_page.hpp"

#include <algorithm>
#include <array>

#include "cli/frf/frf_text.hpp"
#include "report/decimate.hpp"
#include "report/frf_curves.hpp"
#include "report/page/contents.hpp"
#include "report/page/limits.hpp"
#include "report/page/page.hpp"

namespace jointid::cli {
namespace {

report::Choice frf_choice(const FrfRun& run, std::size_t r, std::size_t c) {
  const frf::FrfSet& set = run.made.set;
  std::vector<Complex> values;
  std::vector<double> coherence;
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    values.push_back(set.values[set.index(line, r, c)]);
    coherence.push_back(run.made.coherence[set.index(line, r, c)]);
  }
  const std::array both = {report::magnitudes(values), coherence};
  const std::vector<std::size_t> kept = report::keep_peaks(both, report::most_points);
  const std::string name = set.header.response[r].name() + " / " + set.header.reference[c].name();
  const auto plot = [&](const std::string& title, report::Axis y, std::size_t which) {
    return report::CurvePlot{title,
                             {"frequency (Hz)", false},
                             std::move(y),
                             report::picked(set.header.frequency_hz, kept),
                             {{"measured", report::picked(both[which], kept), report::Style::line}},
                             {},
                             {},
                             {}};
  };
  report::CurvePlot of_coherence = plot("Coherence", {"coherence", false}, 1);
  of_coherence.y_range = {0.0, 1.05};
  return {name,
          {plot("Magnitude of " + name, {report::receptance_label(set.header.response[r], set.header.reference[c]), true}, 0),
           of_coherence}};
}

}  // namespace

std::string frf_report(const FrfRun& run) {
  const frf::FrfHeader& header = run.made.set.header;
  report::ReportPage page(run.record_files.front(), "jointid frf");
  page.section("Averages");
  page.add(report::Text{estimate_text(run)});
  for (const std::string& note : notes(run)) page.add(report::Text{note});
  page.add(averages_table(run));
  page.section("FRFs");
  report::PlotGroup group{"FRF", {}};
  for (std::size_t e = 0; e < std::min(header.entries(), report::most_frfs); ++e) {
    group.choices.push_back(frf_choice(run, e % header.response.size(), e / header.response.size()));
  }
  page.add(group);
  if (const std::string cut = report::drawn_text(group.choices.size(), header.entries()); !cut.empty())
    page.add(report::Text{cut, true});
  page.add(coherence_table(run), "Coherence");
  page.section(run.options.segments ? "Segments" : "Blows");
  page.add(stretches_table(run));
  return page.html();
}

}  // namespace jointid::cli

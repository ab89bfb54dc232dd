#include "report/frf/frf_page.hpp"

#include <algorithm>
#include <array>

#include "report/decimate.hpp"
#include "report/frf/frf_text.hpp"
#include "report/frf_curves.hpp"
#include "report/page/contents.hpp"
#include "report/page/limits.hpp"
#include "report/page/page.hpp"

namespace jointid::report {
namespace {

Choice frf_choice(const tasks::FrfRun& run, std::size_t r, std::size_t c) {
  const frf::FrfSet& set = run.made.set;
  std::vector<Complex> values;
  std::vector<double> coherence;
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    values.push_back(set.values[set.index(line, r, c)]);
    coherence.push_back(run.made.coherence[set.index(line, r, c)]);
  }
  const std::array both = {magnitudes(values), coherence};
  const std::vector<std::size_t> kept = keep_peaks(both, most_points);
  const std::string name = set.header.response[r].name() + " / " + set.header.reference[c].name();
  const auto plot = [&](const std::string& title, Axis y, std::size_t which) {
    return CurvePlot{title,
                     {"frequency (Hz)", false},
                     std::move(y),
                     picked(set.header.frequency_hz, kept),
                     {{"measured", picked(both[which], kept), Style::line}},
                     {},
                     {},
                     {}};
  };
  CurvePlot of_coherence = plot("Coherence", {"coherence", false}, 1);
  of_coherence.y_range = {0.0, 1.05};
  return {
      name,
      {plot("Magnitude of " + name, {receptance_label(set.header.response[r], set.header.reference[c]), true}, 0), of_coherence}};
}

}  // namespace

std::string frf_page(const tasks::FrfRun& run) {
  const frf::FrfHeader& header = run.made.set.header;
  ReportPage page(run.record_files.front(), "jointid frf");
  page.section("Averages");
  page.add(Text{estimate_text(run)});
  for (const std::string& note : notes(run)) page.add(Text{note});
  page.add(averages_table(run));
  page.section("FRFs");
  PlotGroup group{"FRF", {}};
  for (std::size_t e = 0; e < std::min(header.entries(), most_frfs); ++e) {
    group.choices.push_back(frf_choice(run, e % header.response.size(), e / header.response.size()));
  }
  page.add(group);
  if (const std::string cut = drawn_text(group.choices.size(), header.entries()); !cut.empty()) page.add(Text{cut, true});
  page.add(coherence_table(run), "Coherence");
  page.section(run.options.segments ? "Segments" : "Blows");
  page.add(stretches_table(run));
  return page.html();
}

}  // namespace jointid::report

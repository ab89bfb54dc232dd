#include "report/frf/frf_page.hpp"

#include "report/frf/frf_plots.hpp"
#include "report/frf/frf_text.hpp"
#include "report/page/limits.hpp"
#include "report/page/page.hpp"

namespace jointid::report {

std::string frf_page(const tasks::FrfRun& run) {
  const frf::FrfHeader& header = run.made.set.header;
  ReportPage page(run.record_files.front(), "jointid frf");
  page.section("Averages");
  page.add(Text{estimate_text(run)});
  for (const std::string& note : notes(run)) page.add(Text{note});
  page.add(averages_table(run));
  page.section("FRFs");
  const PlotGroup group = frf_plots(run, most_frfs, most_points);
  page.add(group);
  if (const std::string cut = drawn_text(group.choices.size(), header.entries()); !cut.empty()) page.add(Text{cut, true});
  page.add(coherence_table(run), "Coherence");
  page.section(run.options.segments ? "Segments" : "Blows");
  page.add(stretches_table(run));
  return page.html();
}

}  // namespace jointid::report

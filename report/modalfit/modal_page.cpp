#include "report/modalfit/modal_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "report/frf_curves.hpp"
#include "report/modalfit/modal_text.hpp"
#include "report/modalfit/stabilisation.hpp"
#include "report/page/contents.hpp"
#include "report/page/heat_map.hpp"
#include "report/page/limits.hpp"
#include "report/page/page.hpp"
#include "report/page/solve_plots.hpp"
#include "report/page/status_banner.hpp"
#include "tasks/modalfit/modal_run.hpp"
#include "tasks/solution_details.hpp"

namespace jointid::report {
namespace {

constexpr std::size_t most_rows = 50;

/// Errors away from antiresonances of what the page shows as the model.
HeatMap error_overview(const tasks::ModalRun& run) {
  std::vector<double> rms_db;
  for (const modalfit::SynthesisError& error : run.symmetric ? run.of_model : run.of_fit) rms_db.push_back(error.rms_db_away);
  return error_map("rms error in dB away from antiresonances, responses down, references across", run.fit.response,
                   run.fit.reference, rms_db);
}

/// The FRFs that are drawn: the first, then those that are met worst.
std::vector<std::size_t> drawn_entries(const tasks::ModalRun& run, const std::vector<double>& rms_db) {
  std::vector<std::size_t> out;
  const auto add = [&](std::size_t e, std::size_t most) {
    if (out.size() < most && run.of_fit[e].lines > 0 && std::ranges::find(out, e) == out.end()) out.push_back(e);
  };
  for (std::size_t e = 0; e < run.band.entries(); ++e) add(e, most_frfs - worst_frfs_drawn);
  for (const std::size_t e : tasks::worst_first(rms_db)) add(e, most_frfs);
  return out;
}

tasks::Regenerated overlay_data(const tasks::ModalRun& run, const std::vector<std::size_t>& chosen) {
  tasks::Regenerated out;
  out.frequency_hz = run.band.frequency_hz;
  const std::size_t columns = run.fit.reference.size(), entries = run.band.entries();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::size_t e : chosen) {
    tasks::RegeneratedFrf frf{{run.fit.response[e / columns], run.fit.reference[e % columns]}, {}, {}};
    for (std::size_t i = 0; i < run.band.lines(); ++i) {
      const auto measured = run.band.value(e)[i];
      frf.measured.push_back(measured == 0.0 ? Complex(nan, nan) : measured);
      frf.predicted.push_back(run.regenerated.values[i * entries + e]);
    }
    out.frfs.push_back(std::move(frf));
  }
  return out;
}

/// Its message stands in the banner already.
std::vector<std::string> modalfit_remarks(const tasks::ModalRun& run) {
  std::vector<std::string> out = notes(run);
  std::erase(out, run.fit.message);
  return out;
}

}  // namespace

std::string modal_page(const tasks::ModalRun& run) {
  ReportPage page(run.files, "jointid modalfit");
  const HeatMap errors = error_overview(run);
  page.status(status_banner(name(run.fit.status), run.fit.message, modalfit_remarks(run)));
  page.section("Summary");
  Facts facts{{{"status", name(run.fit.status)},
               {"model", model_text(run.fit.kind)},
               {"FRFs", fmt::format("{} × {}, {} lines", run.band.responses, run.band.references, run.band.lines())},
               {"noise", run.fit.known_noise ? "of the files" : "estimated from neighbouring lines"},
               {"fit of each FRF", synthesis_text(run.of_fit)}}};
  if (run.symmetric) facts.rows.emplace_back("symmetric model", synthesis_text(run.of_model));
  page.add(facts);
  page.section("Modes");
  page.add(modes_table(run));
  page.add(
      Text{"Significance: how much worse the fit would be without the mode, over what noise reaches once in a thousand million. "
           "Rank-one "
           "misfit: mean square of what keeps the residues from one reciprocal shape, over their variances.",
           true});
  if (!run.fit.stabilisation.empty()) {
    page.section("Stabilisation diagram");
    page.add(PlotGroup{"diagram", {{"stabilisation", {stabilisation_diagram(run, run.fit.stabilisation, most_points)}}}});
  }
  page.section("FRFs");
  const std::vector<std::size_t> chosen = drawn_entries(run, errors.values);
  page.add(frf_overlay(overlay_data(run, chosen), std::nullopt, most_points));
  if (const std::string cut = drawn_text(chosen.size(), tasks::worst_first(errors.values).size()); !cut.empty())
    page.add(Text{cut, true});
  page.section("Errors of all FRFs");
  page.add(errors);
  page.add(synthesis_table(run, run.band.entries()), "Synthesis error, worst first", {most_rows, "--json writes all of them"});
  if (!mac_table(run).rows().empty()) {
    page.section("Modes of like shapes");
    page.add(mac_table(run), "", {most_rows, "--json has the MAC of all pairs"});
  }
  return page.html();
}

}  // namespace jointid::report

#include "cli/report/modalfit_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cli/modalfit_text.hpp"
#include "cli/report/limits.hpp"
#include "cli/report/page.hpp"
#include "cli/report/solve_plots.hpp"

namespace jointid::cli::report {
namespace {

constexpr std::size_t most_rows = 50;

/// Whether the pole is one of the fit's modes, nearer than its decay rate or ten standard deviations.
bool is_selected(const ModalRun& run, const modalfit::CandidatePole& pole) {
  const double reach = std::max(std::abs(pole.damping) * pole.frequency_hz, 10.0 * pole.deviation_hz);
  return pole.damping > 0.0 && std::ranges::any_of(run.fit.modes, [&](const modalfit::Mode& mode) {
    return std::abs(mode.pole.frequency_hz - pole.frequency_hz) < reach;
  });
}

std::string label(const modalfit::CandidatePole& pole) {
  return fmt::format("{:.5g} Hz ± {:.1e}, ζ {:.3g} %", pole.frequency_hz, pole.deviation_hz, 100.0 * pole.damping);
}

PlotGroup stabilisation_diagram(const ModalRun& run) {
  ScatterPlot plot{"Stabilisation diagram", {"frequency (Hz)", false}, {"order (pole pairs)", false}, {}, {}};
  PointGroup selected{"stable, at a mode of the fit", {}}, stable{"stable, elsewhere", {}}, fitted{"modes of the fit", {}};
  double highest = 0.0;
  for (const auto& order : run.fit.stabilisation) {
    highest = std::max(highest, static_cast<double>(order.order));
    for (const auto& pole : order.poles) {
      if (pole.damping <= 0.0) continue;
      (is_selected(run, pole) ? selected : stable).points.push_back({pole.frequency_hz, static_cast<double>(order.order), label(pole)});
    }
  }
  for (std::size_t r = 0; r < run.fit.modes.size(); ++r) {
    const modalfit::Pole& pole = run.fit.modes[r].pole;
    fitted.points.push_back({pole.frequency_hz, 1.04 * highest, fmt::format("mode {}: {:.6g} Hz", r + 1, pole.frequency_hz)});
  }
  plot.groups = {selected, stable, fitted};
  return {"diagram", {{"stabilisation", {plot}}}};
}

ident::Regenerated overlay_data(const ModalRun& run) {
  ident::Regenerated out;
  out.frequency_hz = run.band.frequency_hz;
  const std::size_t columns = run.fit.reference.size(), entries = run.band.entries();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t e = 0; e < entries && out.frfs.size() < most_frfs; ++e) {
    if (run.of_fit[e].lines == 0) continue;
    ident::RegeneratedFrf frf{{run.fit.response[e / columns], run.fit.reference[e % columns]}, {}, {}};
    for (std::size_t i = 0; i < run.band.lines(); ++i) {
      const auto measured = run.band.value(e)[i];
      frf.measured.push_back(measured == 0.0 ? ident::Complex(nan, nan) : measured);
      frf.predicted.push_back(run.regenerated.values[i * entries + e]);
    }
    out.frfs.push_back(std::move(frf));
  }
  return out;
}

}  // namespace

std::string modalfit_report(const ModalRun& run) {
  ReportPage page(run.files, "jointid modalfit");
  page.section("Summary");
  Facts facts{{{"status", modalfit::name(run.fit.status)},
               {"model", model_text(run.fit.kind)},
               {"FRFs", fmt::format("{} × {}, {} lines", run.band.responses, run.band.references, run.band.lines())},
               {"noise", run.fit.known_noise ? "of the files" : "estimated from what the fit leaves"},
               {"fit of each FRF", synthesis_text(run.of_fit)}}};
  if (run.symmetric) facts.rows.emplace_back("symmetric model", synthesis_text(run.of_model));
  page.add(facts);
  for (const std::string& note : notes(run)) page.add(Text{note});
  page.section("Modes");
  page.add(modes_table(run));
  page.add(Text{"Significance: how much worse the fit would be without the mode, over what noise reaches once in a thousand million. Rank-one "
                "misfit: mean square of what keeps the residues from one reciprocal shape, over their variances.",
                true});
  page.section("Stabilisation diagram");
  page.add(stabilisation_diagram(run));
  page.section("FRFs");
  page.add(frf_overlay(overlay_data(run), std::nullopt, most_points));
  page.add(synthesis_table(run, most_rows), "Synthesis error, worst first");
  if (!mac_table(run).rows().empty()) {
    page.section("Modes of like shapes");
    page.add(mac_table(run));
  }
  return page.html();
}

}  // namespace jointid::cli::report

#include "report/modalfit/stabilisation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/modalfit/band_indicators.hpp"

namespace jointid::report {
namespace {

constexpr std::size_t indicators_behind = 2;
constexpr double above_all = 1.04;  ///< where the modes stand, over the highest order

std::string pole_label(const modalfit::CandidatePole& pole) {
  return fmt::format("{:.5g} Hz ± {:.1e}, ζ {:.3g} %", pole.frequency_hz, pole.deviation_hz, 100.0 * pole.damping);
}

}  // namespace

bool is_mode(const modalfit::Mode& mode, const modalfit::CandidatePole& pole) {
  const double reach = std::max(std::abs(pole.damping) * pole.frequency_hz, 10.0 * pole.deviation_hz);
  return pole.damping > 0.0 && std::abs(mode.pole.frequency_hz - pole.frequency_hz) < reach;
}

ScatterPlot stabilisation_diagram(const tasks::ModalRun& run, const std::vector<modalfit::OrderPoles>& orders, std::size_t most) {
  ScatterPlot plot;
  plot.title = "Stabilisation diagram";
  plot.x = {"frequency (Hz)", false};
  plot.y = {"order (pole pairs)", false};
  plot.groups = {{"stable, at a mode of the fit", {}}, {"stable, elsewhere", {}}, {"modes of the fit", {}}};
  double highest = 0.0;
  for (const auto& order : orders) {
    highest = std::max(highest, static_cast<double>(order.order));
    for (const auto& pole : order.poles) {
      if (pole.damping <= 0.0) continue;
      const bool found = std::ranges::any_of(run.fit.modes, [&](const modalfit::Mode& mode) { return is_mode(mode, pole); });
      plot.groups[found ? at_mode : elsewhere].points.push_back(
          {pole.frequency_hz, static_cast<double>(order.order), pole_label(pole)});
    }
  }
  for (std::size_t r = 0; r < run.fit.modes.size(); ++r) {
    const modalfit::Pole& pole = run.fit.modes[r].pole;
    plot.groups[of_fit].points.push_back(
        {pole.frequency_hz, above_all * highest, fmt::format("mode {}: {:.6g} Hz", r + 1, pole.frequency_hz)});
  }
  plot.backdrop = band_indicators(run.band, indicators_behind, most);
  return plot;
}

}  // namespace jointid::report

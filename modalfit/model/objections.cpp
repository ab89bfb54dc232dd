#include "modalfit/model/objections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "modalfit/model/uncertainty.hpp"
#include "modalfit/poles/doubled.hpp"
#include "modalfit/poles/prominence.hpp"
#include "modalfit/poles/selection.hpp"

namespace jointid::modalfit {
namespace {

constexpr double most_damping_deviation = 0.5;  ///< of the damping of a mode
constexpr double vague_lines = 4.0;             ///< lines per half width from which a mode must show its damping

}  // namespace

std::vector<std::string> objections(const Band& band, const std::vector<std::size_t>& entries, const FitOptions& options,
                                    const RefinedPoles& refined) {
  const double spacing = (band.frequency_hz.back() - band.frequency_hz.front()) / static_cast<double>(band.lines() - 1);
  const std::size_t n = refined.poles.size();
  const PoleScatter scatter = pole_scatter(band, entries, options.kind, refined);
  const double noise = chi_square_quantile(static_cast<double>(2 * entries.size() + 2), significance_deviations) *
                       std::max(1.0, refined.freedom > 0.0 ? refined.cost / refined.freedom : 1.0);
  const std::vector<Prominence> prominence = prominences(band, entries, options.kind, refined.poles);
  std::vector<std::string> out(n);
  for (std::size_t r = 0; r < n; ++r) {
    const Pole& pole = refined.poles[r];
    const std::size_t at = 2 * r + 1;
    if (!is_inside(pole, band)) continue;
    const double deviation = scatter.factor[at] * std::sqrt(std::max(0.0, refined.covariance[at * 2 * n + at]));
    if (deviation > most_damping_deviation * pole.damping && half_width_hz(options.kind, pole) > vague_lines * spacing) {
      out[r] = fmt::format("its {} is {:.2g} ± {:.2g} %", options.kind.damping == Damping::hysteretic ? "η" : "ζ", 100.0 * pole.damping,
                           100.0 * deviation);
    } else if (prominence[r].flanks < noise) {
      out[r] = "it rests on a single line";
    } else if (!options.modes && prominence[r].share < least_prominence) {
      out[r] = fmt::format("even in the FRF that shows it best it is {:.2g} % of the other terms, less than 1 dB",
                           100.0 * prominence[r].share);
    }
  }
  return out;
}

}  // namespace jointid::modalfit

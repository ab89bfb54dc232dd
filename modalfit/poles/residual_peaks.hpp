#pragma once

#include <cstddef>
#include <vector>

#include "modalfit/band/band.hpp"
#include "modalfit/band/model_kind.hpp"
#include "modalfit/band/pole.hpp"

namespace jointid::modalfit {

/// A peak of what a model leaves of the FRFs.
struct ResidualPeak {
  Pole pole;                  ///< place and width of the peak
  double growth = 0.0;        ///< of the cost without it
  double significance = 0.0;  ///< growth over what noise and the scatter about the peak reach at six standard deviations
};

/// Peaks that no pole of the model explains, largest growth first. The residuals are those of each FRF with poles of its own, at
/// most half a half-power bandwidth off the common ones: FRFs that disagree on a frequency are not taken for two modes. A matched
/// filter, 1/(h + i(f−f₀)) less its straight line, runs over all lines for half widths h of a third of a line spacing and up. A
/// peak stands out where
///   - the FRFs together exceed the six-deviation quantile of χ², over the scatter about the peak itself where that is above the
///   noise;
///   - in some FRF it has more than 6σ by itself, shows on two lines, and reaches a quarter of the sum of moduli of the model's
///   terms.
/// Peaks nearer to a pole than three times the sum of half widths, or to a higher peak than six times, are left out.
std::vector<ResidualPeak> residual_peaks(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind,
                                         const std::vector<Pole>& poles);

}  // namespace jointid::modalfit

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/statistics.hpp"
#include "modalfit/band/band.hpp"
#include "modalfit/band/model_kind.hpp"
#include "modalfit/band/pole.hpp"

namespace jointid::modalfit {

/// How sure a mode must be: its share of the fit beyond the quantile of χ² that noise exceeds once in a thousand million.
inline constexpr double significance_deviations = 6.0;

/// Backward elimination: as long as a mode's share of the fit (Residues::growth, over the mean square of the residuals where that
/// is above 1) is below the quantile for its coefficients and pole, the least significant goes, up to a quarter of them at once.
/// With `modes` given the most significant so many stay instead, whatever the noise.
std::vector<Pole> significant_poles(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind,
                                    std::vector<Pole> poles, std::optional<std::size_t> modes);

}  // namespace jointid::modalfit

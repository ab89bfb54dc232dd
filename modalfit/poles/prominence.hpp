#pragma once

#include <cstddef>
#include <vector>

#include "modalfit/band/band.hpp"
#include "modalfit/band/model_kind.hpp"
#include "modalfit/band/pole.hpp"

namespace jointid::modalfit {

/// A mode is worth its name where its term, at the line nearest to its frequency, is at least this share of the sum of moduli of the
/// model's other terms: 1 dB.
inline constexpr double least_prominence = 0.12;

/// How a mode shows in the FRFs.
struct Prominence {
  double share = 0.0;  ///< of the other terms, the largest of the FRFs that know its residue to four standard deviations
  /// Σ|term|²/σ² over the twelve lines about the nearest one without that: a mode has flanks, a bad line has none.
  double flanks = 0.0;
};

std::vector<Prominence> prominences(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind,
                                    const std::vector<Pole>& poles);

}  // namespace jointid::modalfit

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "modalfit/band/band.hpp"
#include "modalfit/model/modal_fit.hpp"
#include "modalfit/poles/refine.hpp"

namespace jointid::modalfit {

/// [N] why a pole in the range is no mode, or nothing: its damping is hardly known though it spans many lines (a bend of the FRFs), or
/// it rests on one line, or it changes no FRF by 1 dB at its own line (side bands of a resonance, say, by a swaying suspension).
std::vector<std::string> objections(const Band& band, const std::vector<std::size_t>& entries, const FitOptions& options,
                                    const RefinedPoles& refined);

}  // namespace jointid::modalfit

#pragma once

#include <functional>
#include <vector>

#include "response/harmonic/harmonic_balance.hpp"

namespace jointid::response {

/// Solutions at these frequencies (rad/s) in turn, each from the one before; those that did not converge once more from the one
/// after. `advance` is called before each with those so far; what it throws ends the sweep. `begun`: the first ones, of a sweep that was
/// ended like that; the result is that of one sweep, to the last bit.
std::vector<HarmonicSolution> sweep(const HarmonicBalance& balance, const std::vector<double>& omegas, double level,
                                    const std::function<void(const std::vector<HarmonicSolution>&)>& advance = {},
                                    std::vector<HarmonicSolution> begun = {});

}  // namespace jointid::response

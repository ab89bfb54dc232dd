#pragma once

#include <functional>
#include <vector>

#include "response/harmonic/harmonic_balance.hpp"

namespace jointid::response {

/// Solutions at these frequencies (rad/s) in turn, each from the one before; those that did not converge once more from the one
/// after. `advance` is called before each with its number; what it throws ends the sweep.
std::vector<HarmonicSolution> sweep(const HarmonicBalance& balance, const std::vector<double>& omegas, double level,
                                    const std::function<void(std::size_t)>& advance = {});

}  // namespace jointid::response

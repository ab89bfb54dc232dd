#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace jointid::report {

/// In (end − 360°, end].
double within_branch(double phase_deg, double end_deg);

/// How often the curve crosses `end` (a neighbour is taken the shorter way around the circle).
std::size_t crossings(const std::vector<double>& phase_deg, double end_deg);

/// Upper end, in degrees, of the period of 360° in which curves of phases are drawn: of the multiples of 15° that which the
/// curves cross least, 180° where it is as good. At ±180° the phase of a lightly damped structure stays, and its noise crosses.
double branch_end_deg(std::span<const std::vector<double>> phases_deg);

}  // namespace jointid::report

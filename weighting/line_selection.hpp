#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace jointid::weighting {

/// Which lines of an axis are used. Frequencies in Hz, both ends of an interval included.
struct LineSelection {
  std::optional<std::array<double, 2>> range_hz;  ///< default: the whole axis
  std::optional<double> step_hz;                  ///< the lines nearest to lo, lo + step, … instead of all
  std::vector<std::array<double, 2>> exclude_hz;
};

/// Indices of the selected lines, ascending, none twice. The ends of intervals are met within 1e-9 relative, so that an
/// axis computed as f₀ + i·Δf keeps the line that the user wrote.
std::vector<std::size_t> select_lines(std::span<const double> frequency_hz, const LineSelection& selection);

/// Resonances as peaks of s(f) = f²·indicator(f), indicator = Σ|H|² over some FRFs: the local maxima whose prominence is at
/// least a factor 2 (3 dB) on both sides. Multiplicative noise of 5 % moves s by at most a fifth, far below that.
/// Lines where s is zero or not finite (0 Hz, not measured) are skipped.
/// Wrong when the lines are coarser than the resonances: a peak between two lines is not seen.
std::vector<double> find_resonances(std::span<const double> frequency_hz, std::span<const double> indicator);

}  // namespace jointid::weighting

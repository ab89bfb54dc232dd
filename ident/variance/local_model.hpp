#pragma once

#include <span>

#include "frf/set/frf_set.hpp"
#include "ident/variance/noise_fit.hpp"

namespace jointid::ident {

/// Lines of a window for a local rational model of an order, and the least of them that must be measured.
constexpr std::size_t window_lines(std::size_t order) { return 4 * order + 5; }
constexpr std::size_t least_window_lines(std::size_t order) { return 2 * order + 4; }

/// What a local rational model B/A of numerator and denominator `order` leaves of an FRF over neighbouring lines:
/// min Σ|B(f_k) − A(f_k)H_k|² with the highest coefficient of A equal to 1, 2·order + 1 complex parameters (McKelvey & Guérin
/// 2012, Pintelon et al. 2010). E of the square is Σ(1−h_k)|A_k|²σ_k² with the leverages h_k. NaN lines are left out; at least
/// least_window_lines(order) must remain.
SquaredError local_residual(std::span<const double> frequency_hz, std::span<const Complex> frf, std::size_t order);

}  // namespace jointid::ident

#pragma once

/// Differences that lose all digits for small arguments when written down as they stand.
namespace jointid::friction {

/// x + e^{−x} − 1, x ≥ 0.
double linear_minus_exponential(double x);

/// x e^x − e^x + 1, x ≥ 0.
double exponential_excess(double x);

/// e^{−x}(x cosh x − sinh x), x ≥ 0.
double damped_hyperbolic_excess(double x);

/// ∫₀^x t²(1 − e^{−t}) dt, x ≥ 0.
double exponential_second_moment(double x);

/// x − sin(2x)/2, 0 ≤ x ≤ π.
double circular_segment(double x);

/// e^{−x} I₁(x), x ≥ 0.
double scaled_bessel_i1(double x);

}  // namespace jointid::friction

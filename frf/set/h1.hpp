#pragma once

#include <complex>

namespace jointid::frf {

/// E|e|² of an FRF estimated by H1 from `averages` independent records, |H|²(1−γ²)/(γ²(n_d−1)); its real and imaginary part
/// have half each (Bendat & Piersol, Random Data, 4th ed., eq. 9.92, with n_d−1 for n_d, which makes the estimate from a
/// measured coherence unbiased). n_d > 1.
double h1_variance(std::complex<double> frf, double coherence, double averages);

/// The same halves as variances of real and imaginary part, from a measured coherence: one above 1 by rounding counts as 1, and
/// where it is not above 0 nothing is known, NaN.
std::complex<double> h1_part_variances(std::complex<double> frf, double coherence, double averages);

/// Data windows of a spectral estimate.
enum class Window { rectangular, hann };

/// How many independent records n overlapping ones are worth, by the variance of their mean (Welch, IEEE Trans. Audio
/// Electroacoustics AU-15 (1967) 70–73): n_eff = n / (1 + 2 Σ_k (1 − k/n) ρ_k), ρ_k = (∫w(t)w(t+kD)dt / ∫w²dt)²,
/// D = 1 − overlap of a record, 0 ≤ overlap < 1. Holds for white noise over the main lobe of the window.
double effective_averages(int averages, double overlap, Window window);

}  // namespace jointid::frf

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace jointid::oscillation {

struct InformationOptions {
  std::size_t cells = 16;  ///< ≥ 1, of equal width over [min, max] of the whole series
  bool cyclic = false;     ///< x_{i+n} = x_i, so that all n pairs count; else the n − T there are
};

/// Average mutual information of x_i and x_{i+T}, I = Σ P log₂(P/(P_a P_b)) in bits, by counts over the pairs; both marginals are
/// of the same pairs. No correction of the bias (information_bias). Kappagantu (3.20–3.22), whose "square of the samples" is
/// wrong. Throws InputError for fewer than lag + 1 samples or numbers that are not finite.
double mutual_information(std::span<const double> x, std::size_t lag, const InformationOptions& options = {});

/// What a histogram of independent samples shows on average: (cells − 1)²/(2 n ln 2) bits.
double information_bias(std::size_t cells, std::size_t pairs);

/// I at T = 0, 1, …, most_lag, and the smallest T ≥ 1 with I(T) < I(T−1) and I(T) ≤ I(T+1), the usual delay of an embedding.
struct InformationCurve {
  std::vector<double> bits;
  std::optional<std::size_t> first_minimum;
};
InformationCurve information_curve(std::span<const double> x, std::size_t most_lag, const InformationOptions& options = {});

/// The first minimum of a curve over T = 0, 1, …, as above.
std::optional<std::size_t> first_minimum(std::span<const double> curve);

}  // namespace jointid::oscillation

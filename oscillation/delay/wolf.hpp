#pragma once

#include <cstddef>
#include <numbers>
#include <span>

#include "oscillation/delay/embedding.hpp"

namespace jointid::oscillation {

struct WolfOptions {
  Embedding embedding;
  std::size_t theiler = 1;   ///< partners are |i − j| > this
  std::size_t evolve = 5;    ///< m ≥ 1: samples over which a pair is followed
  double smallest = 0.0;     ///< least and largest distance of a new pair, in the unit of the series
  double largest = 0.0;
  double sample_time = 1.0;  ///< s, > 0
  double widest_angle = 0.3 * std::numbers::pi;  ///< beyond it the nearest partner is taken
};

/// Wolf's largest exponent: the mean growth of the distance of a pair of neighbours, replaced along the record.
struct WolfExponent {
  double bits_per_second = 0.0;  ///< NaN without any pair
  std::size_t pairs = 0;         ///< followed
  std::size_t replaced = 0;      ///< pairs whose partner was exchanged
};

/// Wolf, Swift, Swinney & Vastano 1985, formula (3.26) of Kappagantu's thesis: λ = Σ log₂(L′/L) / (m Δt · count), L and L′ the
/// distances of a pair before and after m samples. The new partner has a distance within the bounds and makes the least angle with
/// the pair that it replaces; beyond the widest angle it is the nearest one; without any the pair goes on. One exponent comes out
/// of any record, of noise too, and it changes with m and the bounds: docs/oscillations.md. Throws InputError for options that are
/// 0 or out of order, and for too short a series.
WolfExponent wolf_exponent(std::span<const double> x, const WolfOptions& options);

}  // namespace jointid::oscillation

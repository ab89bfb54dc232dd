#pragma once

#include <complex>

namespace jointid::weighting {

/// The Δ filter of docs/formulas.md §5 (6.61) on measured elements: true when the equation c₁ − c₂ is to be dropped, that is when
/// 2|c₁ − c₂| ≤ Δ(|c₁| + |c₂|), 0 < Δ < 2. Δ = 0 drops none, not even c₁ = c₂.
inline bool drops(double delta, const std::complex<double>& c1, const std::complex<double>& c2) {
  return delta > 0.0 && 2.0 * std::abs(c1 - c2) <= delta * (std::abs(c1) + std::abs(c2));
}

}  // namespace jointid::weighting

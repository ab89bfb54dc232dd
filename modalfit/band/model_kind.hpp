#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace jointid::modalfit {

/// How a mode is damped.
enum class Damping : std::uint8_t {
  viscous,    ///< ω_r² − ω² + 2iζ_rω_rω
  hysteretic  ///< ω_r² − ω² + iη_rω_r² (5.65)
};

std::string name(Damping damping);

/// Parses "viscous" or "hysteretic"; throws InputError (usage) with the nearest valid word.
Damping parse_damping(std::string_view text);

/// The family of models (docs/formulas.md §9); D_r is the denominator that `damping` names, a, b response and reference.
/// Real modes: H_ab = Σ_r A_ab,r/D_r − L_ab/ω² + U_ab with real A. Complex modes, hysteretic: the same with complex A. Complex
/// modes, viscous: Σ_r R_ab,r/(iω−λ_r) + R*_ab,r/(iω−λ*_r), λ_r = ω_r(−ζ_r + i√(1−ζ_r²)). L, U (lower and upper residual) are
/// complex: modes outside the range are damped, too.
struct ModelKind {
  Damping damping = Damping::viscous;
  bool real_modes = false;
};

/// Hysteretic η = 2ζ at resonance.
double damping_per_zeta(const ModelKind& kind);

}  // namespace jointid::modalfit

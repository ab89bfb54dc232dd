#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "modalfit/band/band.hpp"
#include "modalfit/band/model_kind.hpp"
#include "modalfit/poles/refine.hpp"

namespace jointid::modalfit {

/// Half the half-power bandwidth of a pole, Hz: ζf, or ηf/2.
double half_width_hz(const ModelKind& kind, const Pole& pole);

/// The nearest two poles whose distance in the s-plane is below their half-power bandwidth (geometric mean), of those that `kept` does not
/// name.
std::optional<std::array<std::size_t, 2>> doubled_pair(const std::vector<Pole>& poles, const ModelKind& kind,
                                                       const std::vector<std::array<Pole, 2>>& kept);

/// One pole between the two in place of the first; the second goes.
std::vector<Pole> with_one(std::vector<Pole> poles, const std::array<std::size_t, 2>& pair);

/// Whether pole pair[0] of `one` does for the two poles of `two`, which was refined with the same weights. Either of these says
/// so:
///   - FRF by FRF a frequency and damping of its own (to first order, within the half width) save at least half of what the
///   second pole saves, or the rest is
///     below six standard deviations;
///   - in every FRF that tells, the two poles λ₁, λ₂ with residues R₁, R₂ act as one at (R₁λ₁ + R₂λ₂)/(R₁ + R₂), which is no
///   farther
///     from their middle than half the bandwidth.
/// Two modes differ in their shapes, and so need two poles in the same FRF; frequencies that drift from one hammer point to the
/// next do not. A single FRF cannot tell the two: there one pole does.
bool one_pole_does(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind, const RefinedPoles& one,
                   const RefinedPoles& two, const std::array<std::size_t, 2>& pair);

}  // namespace jointid::modalfit

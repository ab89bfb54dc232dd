#pragma once

#include <cstddef>
#include <vector>

#include "modalfit/band/band.hpp"
#include "modalfit/band/model_kind.hpp"
#include "modalfit/band/pole.hpp"

namespace jointid::modalfit {

/// All poles of FRFs without noise, those beyond the range included as far as they show in it: the pencil of Loewner matrices
/// of a sum of the FRFs, L_ij = (v_i − w_j)/(μ_i − λ_j), L'_ij = (μ_i v_i − λ_j w_j)/(μ_i − λ_j), between every other
/// line and the lines between them (Mayo & Antoulas, Linear Algebra Appl. 425 (2007)), over iω with its conjugate for viscous damping,
/// over ω² for hysteretic damping. Its rank is the number of poles. A pole with negative damping, which only stands for others,
/// counts as its mirror image. Empty where the rank is no small part of the lines: noise has full rank.
std::vector<Pole> rational_poles(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind);

}  // namespace jointid::modalfit

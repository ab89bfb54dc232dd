#pragma once

#include <span>
#include <vector>

#include "ident/variance_piece.hpp"

namespace jointid::ident {

/// The law σ² = a|H|² + b of each FRF of a piece that fits its recorded variances best, at up to 512 of the `lines`: few
/// averages make the variances themselves uncertain (by 1/√(n_d−1) of their value).
std::vector<frf::VarianceLaw> smoothed_laws(VariancePiece& part, std::span<const std::size_t> lines);

}  // namespace jointid::ident

#pragma once

#include <optional>
#include <span>
#include <vector>

#include "frf/noise/variance_law.hpp"
#include "frf/set/block_pieces.hpp"
#include "frf/set/frf_source.hpp"

namespace jointid::ident {

/// For each FRF of the piece whose transpose is in the same file: the law of both from E|H_ij − H_ji|² = σ_ij² + σ_ji² at up
/// to 512 of the `lines`. Empty for driving points, without a transpose, and where the two are copies of each other (their
/// difference is mostly below single precision), which says nothing of the noise. Errors that break reciprocity but not
/// smoothness (places, directions) count as noise.
std::vector<std::optional<frf::VarianceLaw>> mirror_laws(frf::FrfSource& source, const frf::BlockPiece& piece,
                                                         std::span<const std::size_t> lines);

}  // namespace jointid::ident

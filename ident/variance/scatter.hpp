#pragma once

#include <span>
#include <vector>

#include "frf/noise/variance_law.hpp"
#include "frf/set/block_pieces.hpp"
#include "frf/set/frf_source.hpp"

namespace jointid::ident {

/// Laws of the variances of some FRFs of a file, estimated from their scatter.
struct Scatter {
  std::vector<frf::VarianceLaw> laws;  ///< one per FRF of the piece
  /// FRFs that no local model follows: between the lines they change as much as noise would make them. Their laws include
  /// what the model misses and are upper bounds.
  std::size_t unresolved = 0;
};

/// The noise of each FRF of a piece as σ² = a|H|² + b, b constant in the quantity of the file, from the file's own lines
/// around `lines` (ascending): where the file holds H_ij and H_ji, from their difference; else, and where the two are
/// copies of each other, from the residuals of local rational models (local_residual()) in windows of up to 29 lines. The
/// order is the lowest from 1 to 6 whose noise is about the smallest: a model that is too coarse only adds to it. An FRF
/// is resolved when two orders agree within a factor of 2 in σ² and the noise is below 30 % of the FRF.
/// Throws InputError (data) when the file has fewer than 9 lines there.
Scatter estimate_scatter(frf::FrfSource& source, const frf::BlockPiece& piece, std::span<const std::size_t> lines);

}  // namespace jointid::ident

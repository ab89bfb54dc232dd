#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "frf/set/frf_source.hpp"

namespace jointid::frf {

/// A part of an FRF set, and where its entries stood in the whole: random numbers are counted there, so that the noise of
/// a part is that part of the noise of the whole.
struct Excerpt {
  FrfSet set;
  std::vector<std::uint64_t> line_start;  ///< [F] counter of the line's first entry in the whole
  std::vector<std::uint64_t> entry;       ///< [R,C] place of the entry in a line of the whole
  std::vector<std::uint64_t> shared;      ///< [R,C] the smaller place of the entry and its reciprocal, if the whole has both
};

/// All of a set.
Excerpt whole(FrfSet set);

/// Reads a part of a source.
Excerpt excerpt(FrfSource& source, const Block& block);

}  // namespace jointid::frf

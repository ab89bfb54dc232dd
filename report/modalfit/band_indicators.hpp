#pragma once

#include <cstddef>

#include "report/page/contents.hpp"
#include "modalfit/band/band.hpp"

namespace jointid::report {

/// Complex mode indicator functions (Shih et al. 1988): the first `count` singular values of the matrix of receptances, line by
/// line, over at most `most` lines, peaks of the norm of all receptances kept. A mode is a peak of the first, a second mode at the
/// same frequency one of the second. Of more than 12 references an even selection. FRFs that were not measured count as zero.
Backdrop band_indicators(const modalfit::Band& band, std::size_t count, std::size_t most);

}  // namespace jointid::report

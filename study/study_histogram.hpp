#pragma once

#include <vector>

#include "ident/scene/scene.hpp"

namespace jointid::study {

/// Bins of equal width from low to high over a column of a study's result file. Each holds its lower end, the last both.
struct ColumnBins {
  std::size_t column = 0;  ///< see StudyColumns
  double low = 0.0, high = 1.0;  ///< low < high
  std::size_t bins = 1;          ///< > 0
};

struct Histogram {
  double low = 0.0, high = 1.0;
  std::vector<std::size_t> counts;
  std::size_t outside = 0;
};

/// How often the trials with status ok fall into each bin; NaN is not counted. The file is read once, in pieces: memory does not
/// depend on the number of trials. Throws InputError when it is no table.
std::vector<Histogram> study_histograms(const ident::Path& file, const std::vector<ColumnBins>& columns);

}  // namespace jointid::study

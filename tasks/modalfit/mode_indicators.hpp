#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <vector>

namespace jointid::tasks {

/// Complex mode indicator functions (Shih et al. 1988): the first `count` singular values of the matrix of receptances, largest
/// first, one row per value over `lines`; a value that is 0 is NaN, as it has no place on a logarithmic axis. A mode is a peak of
/// the first, a second mode at the same frequency one of the second. Of more than 12 references an even selection. `receptance`:
/// of a response and a reference at a line; what is not finite counts as 0. `interrupted` is asked line by line, and Interrupted
/// thrown.
struct FrfMatrix {
  std::size_t responses = 0, references = 0;
  std::function<std::complex<double>(std::size_t response, std::size_t reference, std::size_t line)> receptance;
};
std::vector<std::vector<double>> mode_indicators(const FrfMatrix& frfs, const std::vector<std::size_t>& lines, std::size_t count,
                                                 const std::function<bool()>& interrupted = {});

}  // namespace jointid::tasks

#pragma once

#include <complex>
#include <vector>

#include "ident/tasks/couple.hpp"

namespace jointid::cli::report {

/// A predicted FRF over the lines of the result.
struct PredictedFrf {
  frf::Dof response, reference;
  std::vector<std::complex<double>> value;     ///< m/N
  std::vector<std::complex<double>> variance;  ///< of real and imaginary part; empty when the result has none
  std::vector<std::complex<double>> with_all;  ///< with all conditions; empty without `bounds`
};

/// Reads back up to `most` FRFs of what coupling wrote, point FRFs first. Throws InputError for files that are gone.
std::vector<PredictedFrf> read_predicted(const ident::CoupleResult& result, std::size_t most);

}  // namespace jointid::cli::report

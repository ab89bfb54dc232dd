#pragma once

#include <complex>
#include <vector>

#include "frf/set/frf_source.hpp"
#include "tasks/couple.hpp"

namespace jointid::tasks {

/// A predicted FRF over the lines of the result, CoupleResult::frequency_hz.
struct PredictedFrf {
  frf::Dof response, reference;
  std::vector<std::complex<double>> value;       ///< m/N
  std::vector<std::complex<double>> variance;    ///< of real and imaginary part; empty when the result has none
  std::vector<std::complex<double>> with_all;    ///< with all conditions; empty without `bounds`
  std::vector<std::complex<double>> measured{};  ///< what it is compared with, NaN on lines that were not measured; empty without
};

/// Reads back up to `most` FRFs of what coupling wrote, point FRFs first. Throws InputError for files that are gone.
std::vector<PredictedFrf> read_predicted(const CoupleResult& result, std::size_t most);

/// The same of sets in memory; none where no line was coupled.
std::vector<PredictedFrf> predicted_of(const CoupledSets& coupled, std::size_t most);

/// Puts beside the predicted FRFs what was measured of the same coordinates, on lines that agree to a millionth of the frequency.
void compare_with(frf::FrfSource& measured, const std::vector<double>& frequency_hz, std::vector<PredictedFrf>& frfs);

/// 20 log10 |predicted/measured|, rms over the lines that both have; NaN without any.
double error_db(const PredictedFrf& frf);

}  // namespace jointid::tasks

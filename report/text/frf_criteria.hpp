#pragma once

#include <complex>
#include <span>
#include <string>

namespace jointid::report {

/// How two FRFs look alike over the lines that both have: FRAC, which does not see a factor, and the mean of LAC, which does not see
/// phase (correlation/criteria.hpp). Zeros are not measured. NaN where there is no such line.
struct FrfCriteria {
  double frac = 0.0, lac = 0.0;
};

FrfCriteria criteria_of(std::span<const std::complex<double>> measured, std::span<const std::complex<double>> predicted);

/// Six digits, as FRAC is close to 1; "–" for NaN.
std::string criterion_text(double value);

/// "FRAC 0.970000, LAC 0.950000"; empty where there is no line.
std::string criteria_text(std::span<const std::complex<double>> measured, std::span<const std::complex<double>> predicted);

}  // namespace jointid::report

#pragma once

#include <limits>
#include <vector>

namespace jointid {

/// A number that is not known.
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The normal quantile of 97.5 %: half the width of a 95 % interval in standard deviations.
inline constexpr double normal_95 = 1.959963984540054;

/// The upper of the two middle ones of an even number; NaN of none.
double median(std::vector<double> values);

/// Quantile p, 0 ≤ p ≤ 1, of n > 0 ascending values: linear between the order statistics at (n−1)p (Hyndman & Fan 1996, type 7).
double quantile(const std::vector<double>& ascending, double p);

/// Median and 5 % and 95 % quantile of a sample.
struct Spread {
  double low = 0.0, median = 0.0, high = 0.0;
};

/// Of the values that are not NaN; NaN when there is none.
Spread spread(std::vector<double> values);

/// The quantile of χ² with `freedom` degrees of freedom at the normal quantile `deviations` (Wilson & Hilferty 1931).
double chi_square_quantile(double freedom, double deviations);

}  // namespace jointid

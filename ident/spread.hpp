#pragma once

#include <vector>

namespace jointid::ident {

/// Median and 5 % and 95 % quantile of a sample.
struct Spread {
  double low = 0.0, median = 0.0, high = 0.0;
};

/// Quantile p, 0 ≤ p ≤ 1, of n > 0 ascending values: linear between the order statistics at (n−1)p (Hyndman & Fan 1996, type 7).
double quantile(const std::vector<double>& ascending, double p);

/// Of the values that are not NaN; NaN when there is none.
Spread spread(std::vector<double> values);

}  // namespace jointid::ident

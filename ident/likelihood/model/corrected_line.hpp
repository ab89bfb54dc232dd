#pragma once

#include <span>

#include "ident/likelihood/line/line_data.hpp"

namespace jointid::ident {

/// A line without its systematic errors if these were `phi` (zeros where it is empty): values times what puts them right, weights
/// over the size of it, so that a residual stays what it is in the errors of the measurement, and the terms of their derivatives.
/// Covariances between FRFs stay as they are, to first order.
LineData corrected_line(const LineData& measured, std::span<const SystematicUnknown> unknowns, std::span<const double> phi);

/// The terms of corrected_line() without `phi`, which leaves the line as it is, in place of those of another line.
void write_terms(const LineData& measured, std::span<const SystematicUnknown> unknowns, SystematicTerms& out);

}  // namespace jointid::ident

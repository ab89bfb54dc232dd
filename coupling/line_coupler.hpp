#pragma once

#include <optional>

#include "coupling/error_sums.hpp"
#include "coupling/layout.hpp"
#include "coupling/options.hpp"
#include "coupling/propagation.hpp"

namespace jointid::coupling {

/// How a line went.
struct LineRecord {
  double condition = 0.0;     ///< of S in the 1-norm, with all conditions that are met on some line; NaN when not measured
  std::size_t kept = 0;       ///< singular values, or conditions, that were used
  bool usable = true;         ///< false: something needed was not measured, or S is singular; the FRFs are then NaN
  std::vector<double> alpha{};  ///< mtc: of each condition, before it is coupled
  std::vector<double> sigma{};  ///< fixed, noise, picard: singular values of S, descending
  std::vector<double> limit{};  ///< as long as sigma: what each had to exceed, see Truncation
};

/// The rows and columns of a line's H.
struct LineFrame {
  Wanted wanted;
  std::vector<Index> twin;                              ///< see propagate()
  std::vector<std::size_t> row_body, column_body;       ///< see rc()
  bool with_errors = false;                             ///< CoupledLine::errors are asked for, with Options::uncertainty
};

struct CoupledLine {
  ComplexMatrix frf;      ///< at frame.wanted
  LineVariance variance;  ///< with Options::uncertainty
  frf::ErrorSums errors;  ///< with LineFrame::with_errors; no terms where the line is not usable
  LineRecord record;
};

/// Couples one line. `h`: parts side by side, those taken out with a minus sign; `variance` of its entries where
/// needs_variance(), zero across parts.
CoupledLine couple_line(const MatrixRef& h, const LineVariance& variance, double frequency_hz, const LineFrame& frame,
                        const Layout& layout, const Options& options);

}  // namespace jointid::coupling

#pragma once

#include <complex>
#include <memory>
#include <vector>

#include "ident/likelihood/line/line_layout.hpp"
#include "ident/likelihood/line/scaled_frfs.hpp"
#include "ident/likelihood/line/systematic_errors.hpp"
#include "minimise/linear/correlation.hpp"

namespace jointid::ident {

/// Measured values of one block and their weights 1/σ of real and imaginary part; weight 0: not measured.
struct Channel {
  std::vector<Complex> value, weight;
};

/// One line as the likelihood sees it, in the order of a LineLayout.
struct LineData {
  double omega = 0.0;  ///< rad/s
  Channel sub_jn, sub_jj, asm_jn, asm_jj, drop_nn;
  std::size_t measured = 0;  ///< real numbers with a weight
  std::shared_ptr<const minimise::Correlation> correlation;  ///< of the errors; empty where they are independent
  std::shared_ptr<const SystematicFrfs> systematic{};  ///< as measured; empty where there are none
  std::shared_ptr<const ScaledFrfs> scaled{};          ///< empty where no part is a model with an error
  std::shared_ptr<const SystematicTerms> terms{};      ///< of corrected_line()

  /// Real conditions that the measured numbers are left with: the expected χ² of the line at the true joint.
  double redundancy(const LineLayout& layout) const {
    return static_cast<double>(measured) - 2.0 * static_cast<double>(layout.variables());
  }
};

}  // namespace jointid::ident

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "weighting/weighting.hpp"

namespace jointid::weighting {

/// The equations of one line, A Z_j B = C₁ − C₂ with A [M×N], B [N×L]: element (m,l) of C is one equation, and the element
/// of its coefficient row for Z_j(p,q) is A(m,p)·B(q,l). Hence its largest coefficient is row_max(m)·column_max(l).
struct LineShape {
  std::span<const double> row_max;             ///< [M] max_p |A(m,p)|
  std::span<const double> column_max;          ///< [L] max_q |B(q,l)|
  std::span<const std::uint8_t> column_class;  ///< [L] 0 or 1: which named equation of the row it belongs to
  std::span<const std::uint8_t> keep;          ///< [M·L] 1 = in use; empty = all
};

/// Weight of equation (m,l) = row[class(l)·M + m] · column[l]. Without a mask row[] is the same for both classes, so the
/// weighted line stays one Kronecker product.
struct LineWeights {
  std::vector<double> row;     ///< [2·M]
  std::vector<double> column;  ///< [L]
};

/// Weights of one line for none, WB, WBG and WBS. WA depends on T_f and T and is applied to the compressed rows: here it
/// gives ones. Equations whose largest coefficient is zero get weight 0 and must not be in use.
void line_weights(Weighting weighting, const LineShape& shape, LineWeights& weights);

}  // namespace jointid::weighting

#pragma once

#include "ident/likelihood/data/symmetric_frfs.hpp"
#include "ident/likelihood/line/line_data.hpp"
#include "ident/likelihood/line/line_state.hpp"
#include "ident/likelihood/line/symmetric.hpp"

namespace jointid::ident {

/// Something of every FRF of a line, over all coordinates of a LineLayout.
template <class T>
struct BothSystems {
  Symmetric<T> substructures, assembly;
};

/// The values that a state and a joint Z give to the measured FRFs of a line; NaN where not measured. H_sub(n,n) and H_asm(n,n)
/// stand alone in their rows: they share the residual of `difference`, D, by their variances.
BothSystems<Complex> estimated_frfs(const LineLayout& layout, const BothMeasured& measured, const Channel& difference,
                                    const LineState& state, const ComplexMatrix& z);

}  // namespace jointid::ident

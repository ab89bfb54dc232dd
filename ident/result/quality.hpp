#pragma once

#include "ident/result/solution.hpp"

namespace jointid::ident {

/// RJCF, ARVF and rms relative error of `identified` against `exact` (docs/formulas.md §6; 6.64, 6.65), over the
/// upper-triangle elements that are not exactly zero. With u_i = identified/exact: RJCF = (Σu)²/(n Σu²), ARVF = Σu/n.
/// Several square matrices (of bands) may stand one below the other. Empty when every such element of `exact` is zero.
std::optional<Quality> judge(const Matrix& identified, const Matrix& exact);

}  // namespace jointid::ident

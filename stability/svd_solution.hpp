#pragma once

#include "ident/algebra/accumulator.hpp"
#include "ident/algebra/linear_solution.hpp"

namespace jointid::stability {

/// The reduced least-squares problem by the singular value decomposition of its stacked triangles, columns scaled to about
/// unit length; singular values ≤ 16·n·ε·σ₁ count as zero. The most careful and slowest route, for comparison.
ident::LinearSolution solve_svd(ident::Accumulator& accumulator);

}  // namespace jointid::stability

#pragma once

#include "minimise/linear/accumulator.hpp"
#include "minimise/linear/linear_solution.hpp"

namespace jointid::stability {

/// The reduced least-squares problem by the singular value decomposition of its stacked triangles, columns scaled to about
/// unit length; singular values ≤ 16·n·ε·σ₁ count as zero. The most careful and slowest route, for comparison.
minimise::LinearSolution solve_svd(minimise::Accumulator& accumulator);

}  // namespace jointid::stability

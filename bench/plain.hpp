#pragma once

#include <vector>

#include "problems/problem.hpp"

namespace jointid::bench {

/// Case A1 the plain way, for comparison: all equations nn and nj of all lines written out (E = A ⊗ Bᵀ), multiplied by T_f
/// and T, weighted by WA, stacked, and one dense QR. Only the pivoted QR tells the rank, as jointid does. Returns the unknowns in
/// the order K(1,1) … K(4,4), D(1,1) … D(4,4).
enum class DenseQr { pivoted, unpivoted };
std::vector<double> solve_plainly(const problems::Measurement& measurement, DenseQr qr);

}  // namespace jointid::bench

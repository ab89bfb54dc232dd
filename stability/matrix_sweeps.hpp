#pragma once

#include "stability/measurement.hpp"
#include "stability/refined_solution.hpp"

namespace jointid::stability {

/// Plain matrices that are known to be hard, as rows of a least-squares problem.

/// 1/(i+j+1), size × size; every y = 1, the right-hand side rounded to double.
Rows hilbert(std::size_t size);

/// [1 1 … 1; δI] of Läuchli, y = √1, √2, …: the normal equations lose δ² against 1.
Rows laeuchli(std::size_t unknowns, double delta);

/// Rows of a smooth problem (monomials on [0,1]) with weights that fall from 1 to 1/spread in random order, as Powell and
/// Reid's (1969); y = 1 up to a residual that the weights amplify.
Rows weighted(std::size_t rows, std::size_t unknowns, double spread);

/// A problem's rows by solver normal, qr or spqr or by a way of this folder, against its solution in 50 digits. Bounds are those of
/// LinearSolution::rounding.
Measured measure(const Rows& rows, Way way);

}  // namespace jointid::stability

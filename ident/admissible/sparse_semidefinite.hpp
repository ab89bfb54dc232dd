#pragma once

#include <Eigen/SparseCore>
#include <optional>

#include "ident/admissible/semidefinite_least_squares.hpp"

namespace jointid::ident {

/// min ½(θ − θ̂)ᵀN(θ − θ̂)/unit² subject to S_k(θ) ⪰ 0 for all k, N sparse and positive definite, its lower triangle: the steps of
/// solve_semidefinite() with sparse factors of N + Σ 𝒜*(ΛS⁻¹𝒜), which has N's pattern and that of the blocks. Where all that
/// holds at its limit are bounds of single unknowns, the others follow exactly, and are checked: inside, and all multipliers ≥ 0.
/// `x` is θ itself; multipliers are those of the objective above. Empty where N is not positive definite to rounding.
std::optional<SemidefiniteFit> solve_sparse_semidefinite(const std::vector<SymmetricBlock>& blocks,
                                                         const Eigen::VectorXd& estimate,
                                                         const Eigen::SparseMatrix<double>& information, double unit);

}  // namespace jointid::ident

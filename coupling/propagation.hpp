#pragma once

#include <vector>

#include "coupling/condition.hpp"

namespace jointid::coupling {

using RealMatrix = Eigen::MatrixXd;

/// What the errors of some columns of a line have in common over some rows (frf::FrfSet::reference_correlation): forces that
/// acted at once.
struct SharedColumns {
  std::vector<Index> rows, columns;
  ComplexMatrix correlation;  ///< [columns, columns]
};

/// Variances of the real and the imaginary part of the FRFs of a line, each [rows, columns]; NaN: not known. `covariance`: of
/// each column the circular covariances E[e_r e_s*] of its rows, r ≠ s, what stands on the diagonal does not matter; empty: the
/// rows are independent. Columns are, too, but for those that `shared` names.
struct LineVariance {
  RealMatrix real, imaginary;
  std::vector<ComplexMatrix> covariance{};
  std::vector<SharedColumns> shared{};
  std::vector<ComplexMatrix> with_joint{};  ///< of the parts' FRFs: E[ε θ_m] for each unknown of the joints (JointUncertainty)
};

/// Whether an FRF and its transpose are one measurement: they differ by no more than 1e-12 of their size, which two measurements
/// never do.
inline bool is_one_measurement(Complex there, Complex back) { return std::abs(there - back) <= 1e-12 * std::abs(there); }

/// Lower K of the covariance K Kᴴ of some rows of column l, with the variances on its diagonal; rows that are not known are zero.
ComplexMatrix covariance_factor(const LineVariance& variance, const std::vector<Index>& rows, Index l);

/// The differential of coupling, δH_asm = L δH R (docs/formulas.md §11b): L = [I | 0] + …, where all but `own` entries of 1 stand in the
/// columns (rows of R) of the coordinates that conditions or joints name, the first b.
struct Sensitivity {
  ComplexMatrix left;   ///< [wanted rows, b] without the 1 of rows behind b
  ComplexMatrix right;  ///< [b, wanted columns]
};

/// L = (I − H Bᵀ S⁺ B) for the wanted rows, R = (I − Bᵀ S⁺ B H) for the wanted columns, b = `coordinates`.
Sensitivity sensitivity(const MatrixRef& h, const Conditions& conditions, const MatrixRef& s_inverse, const Wanted& wanted,
                        Index coordinates);

/// The same with joints inserted before: L₂L₁ and R₁R₂ from those of the conditions, which saw H with the joint, and those of
/// the joint, L₁ = I − H_:j M, R₁ = I − M H_j:, M = (I + Z H_jj)⁻¹ Z, for all rows and columns of `h`, which has no joint yet.
Sensitivity before(const Sensitivity& conditions, const MatrixRef& h, const std::vector<Index>& at, const MatrixRef& z,
                   const Wanted& wanted);

/// Variances of H_asm to first order for errors of H that are independent from entry to entry, except for what covariances say of
/// the rows of a column and that FRFs there and back, (k,l) and (l,k), that are one measurement have one error; with covariances
/// those of the result, E[δ_rc δ*_sc] = Σ_l |R_lc|² (L C_l Lᴴ)_rs + Σ_{l≠m} R_lc R*_mc ρ_lm (L K_l K_mᴴ Lᴴ)_rs, which FRFs there
/// and back have no part in. `twin`: for each row of H behind b the column of the same coordinate, or −1. How dropped singular
/// vectors turn with H is left out. Costs O(rows·columns·b) per line, and b² per FRF when errors are shared.
LineVariance propagate(const Sensitivity& sensitivity, const MatrixRef& h, const LineVariance& variance, const Wanted& wanted,
                       const std::vector<Index>& twin);

}  // namespace jointid::coupling

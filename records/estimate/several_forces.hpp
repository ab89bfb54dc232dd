#pragma once

#include <vector>

#include "records/estimate/estimate.hpp"

namespace jointid::records {

/// Spectra of segments with m forces at once and R motions.
struct SeveralForces {
  std::size_t lines = 0, forces = 0, responses = 0, count = 0;
  std::vector<Complex> force;   ///< [n, m, F]
  std::vector<Complex> motion;  ///< [n, R, F]
};

/// H1 of several forces that act at once, H = S_xf S_ff⁻¹ with S_ff = Σ F Fᴴ [m,m] and S_xf = Σ X Fᴴ [R,m] (Bendat & Piersol,
/// Random Data, ch. 7), as one Estimate per force. Coherences are multiple ones, 1 − Σ|E_r|²/Σ|X_r|² of the residuals E = X − H
/// F, the same for all forces. Covariances of force c: Σ_h E_rh E_sh* [S_ff⁻¹]_cc / (n_e − m), a factor of which
/// has n − m columns. What the errors to different forces have in common is ρ_cd = [S_ff⁻¹]_dc / √([S_ff⁻¹]_cc [S_ff⁻¹]_dd)
/// (frf::FrfSet::reference_correlation), [line, m, m]: it is known of the forces alone.
/// NaN on lines on which the forces depend on each other (rank of S_ff, each force scaled to 1, below m at 1e-10); noise is NaN
/// unless n_e > m.
struct SeveralEstimates {
  std::vector<Estimate> of_force;
  std::vector<Complex> reference_correlation;
};

SeveralEstimates estimate(const SeveralForces& spectra, double effective, CovarianceForm form = CovarianceForm::pairs);

}  // namespace jointid::records

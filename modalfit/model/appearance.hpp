#pragma once

#include "modalfit/band/band.hpp"
#include "modalfit/model/modal_fit.hpp"

namespace jointid::modalfit {

/// Says of a fit that is not usable what its FRFs look like in place of what to do with the range, where one of these is so:
///   - conjugated (time convention exp(−iωt)), or inverted (force over motion; FRF by FRF, or as a matrix where it is square): poles of
///     the FRFs put right leave at most a quarter of the residuals (rms), and a tenth of the FRFs.
void explain(ModalFit& fit, const Band& band, const FitOptions& options);

/// FRFs that are real or imaginary throughout, as stored, have no damping: magnitudes and real parts have no modal model (poor_fit where a
/// fit is usable by its decibels), and a model without damping is doubtful. Whether they are; else the fit stays as it is.
bool doubt_phase(ModalFit& fit, const Band& band);

}  // namespace jointid::modalfit

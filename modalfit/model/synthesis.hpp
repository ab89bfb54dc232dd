#pragma once

#include <vector>

#include "frf/set/frf_set.hpp"
#include "modalfit/band/band.hpp"
#include "modalfit/model/fit.hpp"
#include "modalfit/model/symmetric_model.hpp"

namespace jointid::modalfit {

/// FRFs of a symmetric model at the header's DOFs (signs included) and lines, with variances. A DOF that the model does not have
/// gives NaN, and so does a line outside its range. To first order, the variances are those of shapes (between the coordinates
/// of a mode), poles (mode by mode) and residual terms. Correlations between modes, and of modes with residual terms, are left
/// out.
frf::FrfSet regenerate(const SymmetricModel& model, frf::FrfHeader header);

/// FRFs of a fit, entry by entry as measured, on the lines of `header` inside the range of the band; for sets without a symmetric
/// model. Variances are those of the coefficients, without correlations.
frf::FrfSet regenerate(const ModalFit& fit, frf::FrfHeader header, const std::array<double, 2>& range_hz);

/// Error of a model against the measured FRFs.
struct SynthesisError {
  double rms_db = 0.0;       ///< rms over lines of 20 log10(|model|/|measured|), NaN when nothing was measured
  double rms_db_away = 0.0;  ///< the same without antiresonances and lines with noise above a tenth of the model
  std::size_t lines = 0, lines_away = 0;
};

/// Of every entry of the band. A line is near an antiresonance where the terms of the fit cancel to less than a tenth of the sum
/// of their moduli. Lines that are mostly noise are known by the weights; where the noise was estimated, from 400 lines on.
/// `regenerated`: the band's lines and entries.
std::vector<SynthesisError> synthesis_errors(const ModalFit& fit, const Band& band, const frf::FrfSet& regenerated);

/// Over all entries.
SynthesisError overall(const std::vector<SynthesisError>& errors);

}  // namespace jointid::modalfit

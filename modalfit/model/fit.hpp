#pragma once

#include "frf/set/frf_set.hpp"
#include "modalfit/band/band.hpp"
#include "modalfit/model/modal_fit.hpp"

namespace jointid::modalfit {

/// Fits the FRFs of a band. The steps are polyreference poles of increasing order, clusters, significance, residues, and
/// refinement of the poles by maximum likelihood, until selection and refinement agree. Then peaks of the residual FRFs become
/// poles, two poles within a bandwidth become one if one suffices, and significant poles below and above the range are added.
/// Poles in the range that are too vague for modes go to the residual terms. Updates the weights of a band without known noise.
ModalFit fit(Band& band, const frf::FrfHeader& header, const FitOptions& options);

/// Makes an ok or doubtful fit poor_fit if the model is off by more than `most_synthesis_db` outside antiresonances and noise.
inline constexpr double most_synthesis_db = 1.0;
void judge(ModalFit& fit, double rms_db_away);

}  // namespace jointid::modalfit

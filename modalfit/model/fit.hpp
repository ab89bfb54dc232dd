#pragma once

#include "frf/set/frf_set.hpp"
#include "modalfit/band/band.hpp"
#include "modalfit/model/modal_fit.hpp"

namespace jointid::modalfit {

/// Fits the FRFs of a band: polyreference poles of increasing order, clusters, significance, residues, refinement of the poles by
/// maximum likelihood, until selection and refinement agree; then peaks of the residual FRFs become poles until none stands out, two
/// poles within a bandwidth become one where one does, a pole below and one above the range are added where they are significant, and poles
/// in the range that are too vague for modes are left to the residual terms. Updates the weights of a band whose noise is not known.
ModalFit fit(Band& band, const frf::FrfHeader& header, const FitOptions& options);

/// Turns an ok or doubtful fit into poor_fit where the model is more than `most_synthesis_db` off away from antiresonances and noise.
inline constexpr double most_synthesis_db = 1.0;
void judge(ModalFit& fit, double rms_db_away);

}  // namespace jointid::modalfit

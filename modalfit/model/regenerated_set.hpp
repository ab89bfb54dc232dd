#pragma once

#include <string>

#include "frf/set/frf_set.hpp"
#include "modalfit/model/fit.hpp"
#include "modalfit/model/synthesis.hpp"

namespace jointid::modalfit {

/// A set whose FRFs a modal model has replaced.
struct RegeneratedSet {
  frf::FrfSet set;        ///< NaN on lines outside the range; as measured where no model was found
  std::size_t modes = 0;
  SynthesisError error;   ///< of the model against what was measured
  double misfit = 0.0;    ///< mean square of the deviations over the variances of the FRFs (those of the fit where the set has none)
  std::string harm;       ///< why the model is worse than the data, one sentence; empty when it is not
};

/// Fits `measured` and puts the FRFs and variances of the symmetric model in their place (of each FRF's own fit where there is no
/// driving point), also where nothing was measured. The header stays but for its noise record, which becomes variance. The model is said
/// to harm where it is more than 1 dB rms off away from antiresonances, where its deviations are more than twice (in mean square)
/// what the noise of the FRFs explains, and where no mode or no convergence was found.
RegeneratedSet regenerate_set(const frf::FrfSet& measured, const FitOptions& options);

}  // namespace jointid::modalfit

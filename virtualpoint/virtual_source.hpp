#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "frf/noise/noise_model.hpp"
#include "frf/set/frf_source.hpp"
#include "virtualpoint/virtual_point.hpp"

namespace jointid::virtualpoint {

/// A source whose sensors and impacts at virtual points are replaced by the coordinates of these, T_u Y T_fᵀ (Transformation);
/// all other FRFs stay. The source itself where it has channels of none of the points. Blocks are read line by line as they are
/// asked for, of the measured FRFs those that are needed; what depends on an FRF that was not measured is NaN.
///
/// Errors: e_q = T_u E T_fᵀ. The source has variances where the file knows its noise (variances, coherences of two averages or
/// more), else where `noise` gives a law of the measured FRFs; and covariances between the responses of one reference, which the
/// channels in common make even where the file has none: C_c = Σ_k T_f(c,k)² T_u C_k T_uᵀ over the measured references k. What
/// virtual references have in common is left out: an FrfSource has no place for it. Averages and repeats are not those of one FRF
/// any more and are left out.
///
/// Throws InputError as transformation(), and where a DOF of a point is in the file already.
std::unique_ptr<frf::FrfSource> virtual_source(std::unique_ptr<frf::FrfSource> source, const std::vector<VirtualPoint>& points,
                                               const std::optional<frf::NoiseModel>& noise = std::nullopt);

}  // namespace jointid::virtualpoint

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "frf/noise/noise_model.hpp"
#include "frf/set/frf_source.hpp"
#include "virtualpoint/virtual_point.hpp"

namespace jointid::virtualpoint {

/// A source in which virtual points replace their sensors and impacts, T_u Y T_fᵀ (Transformation). All other FRFs stay. It is
/// the source itself if that has no channel of the points. Blocks are read line by line on request, only the necessary FRFs. An
/// FRF that depends on one that was not measured is NaN.
///
/// Errors: e_q = T_u E T_fᵀ. The source has variances if the file has its noise (variances, coherences of two averages or more),
/// or if `noise` gives a model of it. It also has covariances between the responses of one reference; common channels cause them
/// even if the file has none: C_c = Σ_k T_f(c,k)² T_u C_k T_uᵀ over the measured references k. Correlations between virtual
/// references are left out: an FrfSource has no place for them. Averages and repeats are left out, as they are not those of one
/// FRF any more.
///
/// Throws InputError as transformation(), and if a DOF of a point is in the file already.
std::unique_ptr<frf::FrfSource> virtual_source(std::unique_ptr<frf::FrfSource> source, const std::vector<VirtualPoint>& points,
                                               const std::optional<frf::NoiseModel>& noise = std::nullopt);

}  // namespace jointid::virtualpoint

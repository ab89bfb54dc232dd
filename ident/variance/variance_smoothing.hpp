#pragma once

#include <functional>
#include <span>
#include <vector>

#include "base/complex.hpp"
#include "frf/noise/variance_law.hpp"
#include "frf/set/frf_set.hpp"
#include "ident/scene/variance_origin.hpp"

namespace jointid::ident {

/// Reads values and recorded variances of some FRFs of a file at one of its lines.
using ReadRecorded = std::function<void(std::span<const std::size_t> line, std::span<Complex> values, std::span<Complex> variances)>;

/// Whether variances of a file should be smoothed unless a scene says otherwise: from few averages or repeats they are uncertain
/// themselves; as weights they cost up to half of the accuracy and make intervals too narrow. A law fitted over enough lines does not.
bool worth_smoothing(VarianceOrigin origin, const frf::FrfHeader& header);

/// The law σ² = a|H|² + b of each of `entries` FRFs that fits its recorded variances best, at up to 512 of the `lines`: few
/// averages make the variances themselves uncertain (by 1/√(n_d−1) of their value).
std::vector<frf::VarianceLaw> smoothed_laws(const frf::FrfHeader& header, std::size_t entries, const ReadRecorded& read,
                                            std::span<const std::size_t> lines);

}  // namespace jointid::ident

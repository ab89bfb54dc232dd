#pragma once

#include <cstdint>
#include <string>

#include "frf/set/frf_set.hpp"
#include "ident/scene/scene.hpp"

namespace jointid::ident {

/// Where the variances of a file's FRFs come from.
enum class VarianceOrigin : std::uint8_t {
  variance,    ///< the file has them
  repeats,     ///< scatter of repeated runs
  coherence,   ///< H1 from the coherences and averages of the file
  noise_model, ///< the law of [noise] at the measured value
  scatter,     ///< estimated from the scatter of the data
  model        ///< of a model: its noise, 0 where it is exact
};

/// One phrase for reports: "variances in the file", …
std::string phrase(VarianceOrigin origin);

/// Throws InputError (usage) unless the scene has a [noise] section with a law for a single FRF (modal has none).
void require_noise_law(const Scene& scene);

/// What [identify] variance means for a file with this header; for a model nothing. "auto" takes what the file has, then the law of
/// [noise], then the scatter of the data (not for coherences of less than two averages: whoever wrote them meant to say something).
/// Throws InputError (data) for a file that does not have what is asked for, and for coherences from less than two averages,
/// which are 1 whatever the noise is; InputError (usage) where [noise] is needed and missing or has no law (modal).
VarianceOrigin variance_origin(const Scene& scene, const frf::FrfHeader& header);

}  // namespace jointid::ident

#pragma once

#include <cstdint>
#include <string>

#include "frf/frf_set.hpp"
#include "ident/scene.hpp"

namespace jointid::ident {

/// Where the variances of a file's FRFs come from.
enum class VarianceOrigin : std::uint8_t {
  variance,    ///< the file has them
  coherence,   ///< H1 from the coherences and averages of the file
  noise_model  ///< the law of [noise] at the measured value
};

/// One phrase for reports: "variances in the file", …
std::string phrase(VarianceOrigin origin);

/// What [identify] variance means for a file with this header. "auto" takes what the file has, then the law of [noise].
/// Throws InputError (data) for a file that does not have what is asked for, and for coherences from less than two averages,
/// which are 1 whatever the noise is; InputError (usage) where [noise] is needed and missing or has no law (modal).
VarianceOrigin variance_origin(const Scene& scene, const frf::FrfHeader& header);

}  // namespace jointid::ident

#pragma once

#include "problems/response.hpp"

namespace jointid::stability {

/// How the FRFs are stored.
enum class Storage { double_precision, single_precision };

/// problems::frequency_response() in 50-digit arithmetic: H = [K − ω²M + i(ωC + D)]⁻¹ of the matrices and frequencies as they
/// are in double precision, rounded once. Without a window.
frf::FrfSet exact_responses(const problems::Structure& structure, const problems::ResponseRequest& request, Storage storage);

/// Natural frequency number `mode` (0 is the lowest) of the undamped structure in Hz, the nearest number of double precision.
double exact_natural_frequency(const problems::Structure& structure, std::size_t mode);

}  // namespace jointid::stability

#pragma once

#include "problems/structure/response.hpp"

namespace jointid::stability {

/// How the FRFs are stored.
enum class Storage { double_precision, single_precision };

/// A spring (or what else `kind` says) between two DOFs that is added exactly: in the matrices of a Structure a soft one beside stiff
/// ones would be rounded.
struct ExactSpring {
  problems::Kind kind;
  frf::Dof first, second;
  double value;
};

/// problems::frequency_response() in 50-digit arithmetic: H = [K − ω²M + i(ωC + D)]⁻¹ of the matrices and frequencies as they
/// are in double precision, rounded once. Without a window.
frf::FrfSet exact_responses(const problems::Structure& structure, const std::vector<ExactSpring>& springs,
                            const problems::ResponseRequest& request, Storage storage);

/// Natural frequency number `mode` (0 is the lowest) of the undamped structure in Hz, the nearest number of double precision.
double exact_natural_frequency(const problems::Structure& structure, std::size_t mode);

}  // namespace jointid::stability

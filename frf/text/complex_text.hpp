#pragma once

#include <optional>
#include <string_view>

#include "base/complex.hpp"

namespace jointid::frf {

/// A complex number in one cell as other programs write it: "1.2+3.4j" (Python, pandas), "(1.2+3.4j)", "1.2 + 3.4i" (MATLAB, R,
/// Excel), "1.2-j3.4", "1.2+3.4*I", "1.2 + 3.4im" (Julia), "[1.2+3.4j]", and "(1.2,3.4)" (C++), which needs a point, since
/// "(1,5)" may be one number. NaN in either part makes both NaN. Empty for real numbers, infinite ones and anything else.
std::optional<Complex> parse_complex(std::string_view cell, bool decimal_comma);

}  // namespace jointid::frf

#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "base/complex.hpp"

namespace jointid::frf {

/// A complex number in one cell as other programs write it: "1.2+3.4j" (Python, pandas), "(1.2+3.4j)", "1.2 + 3.4i" (MATLAB, R,
/// Excel), "1.2-j3.4", "1.2+3.4*I", "1.2 + 3.4im" (Julia), "[1.2+3.4j]", "complex(1.2,3.4)" and
/// "(1.2,3.4)" (C++), which needs a point, since "(1,5)" may be one
/// number. NaN in either part makes both NaN. Empty for real numbers, infinite ones and anything else.
std::optional<Complex> parse_complex(std::string_view cell, bool decimal_comma);

enum class AngleUnit : std::uint8_t { degrees, radians, unstated };

struct PolarNumber {
  double magnitude = 0.0, angle = 0.0;
  AngleUnit unit = AngleUnit::unstated;
  bool cis = false;  ///< written as "1.2 cis(0.785)"

  /// Angles without a unit are taken for degrees, those of cis for radians.
  Complex value() const;
};

/// "1.2∠-45°", "1.2 @ -45", "1.2 /_ -45 deg", "1.2∠-0.785 rad", "1.2*exp(-0.785j)", "1.2*e^(-j0.785)", whose angles are radians,
/// "1.2 cis(-0.785)", "1.2 angle -45 deg", "1.2<-45°".
/// Empty where the magnitude is below 0, and for anything else.
std::optional<PolarNumber> parse_polar(std::string_view cell, bool decimal_comma);

}  // namespace jointid::frf

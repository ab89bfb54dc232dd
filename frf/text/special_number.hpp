#pragma once

#include <optional>
#include <string_view>

namespace jointid::frf {

/// What programs write in place of a number that is none: NaN, nan(ind), 1.#QNAN, -1.#IND0E+000, NaNQ, and *** where a number did
/// not fit its field, as NaN; inf, Infinity, -1.#INF as infinite. Blanks may stand around it. Empty for anything else, numbers
/// included.
std::optional<double> special_number(std::string_view text);

}  // namespace jointid::frf

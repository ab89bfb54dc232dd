#pragma once

#include <optional>
#include <string_view>

namespace jointid::frf {

/// What programs write in place of a number that is none: NaN, nan(ind), 1.#QNAN, -1.#IND0E+000, NaNQ, and *** where a number did
/// not fit its field, as NaN; inf, Infinity, -1.#INF as infinite. Blanks may stand around it. Empty for anything else, numbers
/// included.
std::optional<double> special_number(std::string_view text);

/// Whether a cell of a table says that it has no value: what special_number() reads as NaN, the errors of spreadsheets (#DIV/0!,
/// #N/A, #NUM!, #WERT!, #NV, Err:502, #####), NA, N/A, <NA>, null, None, missing, and dashes.
bool states_no_value(std::string_view cell);

}  // namespace jointid::frf

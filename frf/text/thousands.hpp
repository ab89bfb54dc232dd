#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace jointid::frf {

/// A number with marks between its thousands without them, with a decimal point: "1,234.5", "1.234,5", "1'234.5", "1 234,5" as
/// "1234.5". Commas and points are marks only where the other one is the decimal sign, blanks only where there is one: "1,234"
/// and "1 234" may be something else, and are empty here, as is anything else.
std::optional<std::string> without_thousands(std::string_view cell);

/// Whether the only sign in a number is a comma before groups of three digits: "1,000".
bool may_be_thousands(std::string_view cell);

}  // namespace jointid::frf

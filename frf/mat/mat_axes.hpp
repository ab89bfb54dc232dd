#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace jointid::frf {

/// The order of the axes of an array of FRFs as a text states it, in letters F (lines), R (responses) and C (references): "FRC" of
/// "FRC", "foi", "f,out,in", "freq x response x reference"; empty where it is none of the three axes.
std::optional<std::string> order_of_axes(std::string_view text);

/// The same of a name for each axis, "response_dof", "sensors": one of the three may have a name that says nothing.
std::optional<std::string> order_of_axes(const std::vector<std::string>& names);

/// How far apart the numbers of neighbouring lines, responses and references are in an array with axes in this order, of these
/// extents [lines, responses, references].
std::array<std::size_t, 3> strides(std::string_view order, const std::array<std::size_t, 3>& extents, bool last_fastest);

}  // namespace jointid::frf

#pragma once

#include <array>
#include <string_view>

namespace jointid::frf {

/// Of the directions of DOFs in the order of their codes 1–6 in UFF dataset 58 (Direction).
inline constexpr std::array<std::string_view, 6> direction_names = {"X", "Y", "Z", "RX", "RY", "RZ"};

}  // namespace jointid::frf

#pragma once

#include <cstddef>

namespace jointid::report {

/// Points of a curve over frequency, and FRFs, that a page draws at most: more than a screen has, and few enough for a phone.
inline constexpr std::size_t most_points = 2400, most_frfs = 16;

/// Of the FRFs that are drawn, so many are those that are met worst.
inline constexpr std::size_t worst_frfs_drawn = 4;

}  // namespace jointid::report

#pragma once

#include <cstddef>

namespace jointid::ident {

/// From so many lines on a fit of large ones begins on an eighth of them: as many tell of all unknowns, and are near where all end.
inline constexpr std::size_t many_lines = 512;

}  // namespace jointid::ident

#pragma once

#include <cstddef>
#include <cstring>

#include "base/kernel.hpp"

namespace jointid::ident {

/// Of so many neighbouring numbers the kernels take multiples.
inline constexpr std::size_t kernel_width = 8;

using Eight = double __attribute__((vector_size(kernel_width * sizeof(double))));

JOINTID_INLINE void load(const double* from, Eight& to) { std::memcpy(&to, from, sizeof(Eight)); }
JOINTID_INLINE void store(const Eight& from, double* to) { std::memcpy(to, &from, sizeof(Eight)); }

}  // namespace jointid::ident

#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace jointid::ident {

/// A place or a size, as Eigen counts them.
inline Eigen::Index at(std::size_t i) { return static_cast<Eigen::Index>(i); }

}  // namespace jointid::ident

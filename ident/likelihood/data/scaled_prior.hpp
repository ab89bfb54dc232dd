#pragma once

#include <cstddef>

namespace jointid::ident {

/// A normal prior of a scaled unknown.
struct ScaledPrior {
  std::size_t column = 0;
  double value = 0.0;
  double weight = 0.0;  ///< 1/σ
};

}  // namespace jointid::ident

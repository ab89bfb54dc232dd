#pragma once

#include <cstddef>

namespace jointid::ident {

/// A frequency line that both systems have.
struct Line {
  double frequency_hz = 0.0;
  std::size_t substructures = 0;  ///< line of that system
  std::size_t assembly = 0;
};

}  // namespace jointid::ident

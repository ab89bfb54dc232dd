#pragma once

#include <span>
#include <utility>
#include <vector>

#include "base/complex.hpp"

namespace jointid::ident {

/// What the FRFs of a line become where stiffness and mass of parts that are models are other ones.
class ScaledFrfs {
 public:
  /// Of an FRF in the value of an element.
  struct Change {
    std::size_t element = 0;                               ///< of a line, in the order x, y, a, b, d; ascending
    Complex value;                                         ///< the FRF now, less what it is as described
    double size = 1.0;                                     ///< over what it is as described
    double share = 1.0;                                    ///< of the variance of the element
    std::vector<std::pair<std::size_t, Complex>> rates{};  ///< ∂value/∂φ by unknowns
  };

  virtual ~ScaledFrfs() = default;

  /// `phi`: of all systematic errors, in standard deviations. By any thread.
  virtual std::vector<Change> at(std::span<const double> phi) const = 0;
};

}  // namespace jointid::ident

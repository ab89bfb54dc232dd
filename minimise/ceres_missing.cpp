// Stands in for ceres_minimum.cpp in a build without Ceres.
#include <stdexcept>

#include "minimise/least_squares.hpp"

namespace jointid::minimise {

bool has_ceres() { return false; }

Minimum ceres_minimum(const LeastSquares&, std::span<const double>, const CeresOptions&) {
  throw std::logic_error("this build lacks Ceres");
}

}  // namespace jointid::minimise

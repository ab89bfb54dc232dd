// Stands in for nlopt_global.cpp in a build without NLopt.
#include <stdexcept>

#include "friction/least_squares.hpp"

namespace jointid::friction {

bool has_nlopt() { return false; }

std::vector<double> nlopt_global(const LeastSquares&, std::span<const double>, double, int) {
  throw std::logic_error("this build lacks NLopt");
}

}  // namespace jointid::friction

// Stands in for nlopt_minimum.cpp in a build without NLopt.
#include <stdexcept>

#include "minimise/least_squares.hpp"

namespace jointid::minimise {

bool has_nlopt() { return false; }

Minimum nlopt_minimum(const Objective&, std::span<const double>, const NloptOptions&) {
  throw std::logic_error("this build lacks NLopt");
}

}  // namespace jointid::minimise

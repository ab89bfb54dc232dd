// Stands in for ipopt_minimum.cpp in a build without Ipopt.
#include <stdexcept>

#include "minimise/least_squares.hpp"

namespace jointid::minimise {

bool has_ipopt() { return false; }

Minimum ipopt_minimum(const LeastSquares&, std::span<const double>, const IpoptOptions&) {
  throw std::logic_error("this build lacks Ipopt");
}

}  // namespace jointid::minimise

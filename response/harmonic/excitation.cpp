#include "response/harmonic/excitation.hpp"

#include <algorithm>

namespace jointid::response {

Eigen::VectorXcd Excitation::of(int harmonic) const {
  const auto found = std::ranges::find(harmonics, harmonic);
  if (found == harmonics.end()) return Eigen::VectorXcd::Zero(amplitudes.cols());
  return amplitudes.row(found - harmonics.begin()).transpose();
}

Excitation Excitation::single(Complex amplitude) { return {{1}, Eigen::MatrixXcd::Constant(1, 1, amplitude)}; }

Harmonics needed_harmonics(const Excitation& force, int largest) {
  const bool odd = std::ranges::all_of(force.harmonics, [](int n) { return n % 2 == 1; });
  return odd ? Harmonics::odd(largest) : Harmonics::all(largest);
}

}  // namespace jointid::response

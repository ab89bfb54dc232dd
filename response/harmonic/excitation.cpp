#include "response/harmonic/excitation.hpp"

#include <algorithm>

namespace jointid::response {

Eigen::VectorXcd Excitation::of(int harmonic) const {
  const Eigen::Index found = row(harmonic);
  if (found < 0) return Eigen::VectorXcd::Zero(amplitudes.cols());
  return amplitudes.row(found).transpose();
}

Eigen::Index Excitation::row(int harmonic) const {
  const auto found = std::ranges::find(harmonics, harmonic);
  return found == harmonics.end() ? -1 : found - harmonics.begin();
}

Excitation Excitation::single(Complex amplitude) { return {{1}, Eigen::MatrixXcd::Constant(1, 1, amplitude)}; }

Harmonics needed_harmonics(const Excitation& force, int largest) {
  const bool odd = std::ranges::all_of(force.harmonics, [](int n) { return n % 2 == 1; });
  return odd ? Harmonics::odd(largest) : Harmonics::all(largest);
}

}  // namespace jointid::response

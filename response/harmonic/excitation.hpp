#pragma once

#include <Eigen/Core>
#include <vector>

#include "response/fourier/harmonics.hpp"

namespace jointid::response {

/// Forces p(t) = Σ Re P_n e^{inωt}; p sin ωt means P₁ = −ip.
struct Excitation {
  std::vector<int> harmonics = {1};  ///< n, ascending
  Eigen::MatrixXcd amplitudes;       ///< P_n, [harmonic, force of the receptance], N

  /// P_n, zero for a harmonic that is not there.
  Eigen::VectorXcd of(int harmonic) const;
  /// Its row of the amplitudes, or −1.
  Eigen::Index row(int harmonic) const;

  /// A force at one place with one harmonic.
  static Excitation single(Complex amplitude);
};

/// The harmonics that an answer up to `largest` needs: odd ones when the force has odd ones only, else all, 0 included.
Harmonics needed_harmonics(const Excitation& force, int largest);

}  // namespace jointid::response

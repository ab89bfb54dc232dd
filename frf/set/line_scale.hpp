#pragma once

#include <cmath>
#include <complex>

#include "frf/set/quantity.hpp"

namespace jointid::frf {

/// Scales the FRFs of one line by a factor that is real or imaginary: stored quantity to receptance or back.
/// An imaginary factor (mobility) swaps the variances of real and imaginary part. At 0 Hz a mobility or an
/// accelerance fixes no receptance: everything becomes NaN, "not measured".
class LineScale {
 public:
  /// receptance = si · c · stored, with `si` the factor from the stored unit to SI units and c =
  /// to_receptance.
  static LineScale to_receptance(Quantity quantity, double si, double frequency_hz) {
    return LineScale(si * frf::to_receptance(quantity, frequency_hz), quantity);
  }
  /// stored = receptance / c, in SI units.
  static LineScale from_receptance(Quantity quantity, double frequency_hz) {
    return LineScale(frf::from_receptance(quantity, frequency_hz), quantity);
  }

  bool is_identity() const { return !imaginary_ && factor_ == 1.0; }

  std::complex<double> value(std::complex<double> h) const {
    return imaginary_ ? std::complex<double>{-factor_ * h.imag(), factor_ * h.real()}
                      : std::complex<double>{factor_ * h.real(), factor_ * h.imag()};
  }
  std::complex<double> variance(std::complex<double> v) const {
    const double squared = factor_ * factor_;
    return imaginary_ ? std::complex<double>{squared * v.imag(), squared * v.real()}
                      : std::complex<double>{squared * v.real(), squared * v.imag()};
  }
  /// Of a row of L, Σ = L Lᴴ, and of the diagonal of Σ.
  std::complex<double> factor(std::complex<double> v) const { return std::abs(factor_) * v; }
  double diagonal(double v) const { return factor_ * factor_ * v; }
  /// Of two FRFs of the line: E[e f*].
  std::complex<double> covariance(std::complex<double> v) const { return factor_ * factor_ * v; }

 private:
  LineScale(std::complex<double> factor, Quantity quantity)
      : factor_(quantity == Quantity::mobility ? factor.imag() : factor.real()),
        imaginary_(quantity == Quantity::mobility) {}

  double factor_;
  bool imaginary_;
};

}  // namespace jointid::frf

#pragma once

#include <memory>
#include <vector>

#include "frf/set/frf_source.hpp"

namespace jointid::frf {

/// Factors of an FRF set: H(line, r, c) → line · response(r) · reference(c) · H, of the conjugate of H where asked.
struct EntryScale {
  bool conjugate = false;
  std::vector<Complex> line;  ///< [F]
  std::vector<double> response, reference;
};

/// What a source hands out under another header, times the factors. Variances: of a factor a + ib on independent real and
/// imaginary parts, (a²v + b²w, b²v + a²w). Covariances: of factors f and g, f g* C, of the conjugate of C where asked.
/// Correlations of references: times the signs of theirs, the conjugate where asked.
std::unique_ptr<FrfSource> scaled_source(std::unique_ptr<FrfSource> source, FrfHeader header, EntryScale scale);

/// The variances of factor · (value with the variances v).
inline Complex scaled_variance(Complex factor, Complex v) {
  const double a = factor.real() * factor.real(), b = factor.imag() * factor.imag();
  if (b == 0.0) return a * v;
  if (a == 0.0) return {b * v.imag(), b * v.real()};
  return {a * v.real() + b * v.imag(), b * v.real() + a * v.imag()};
}

}  // namespace jointid::frf

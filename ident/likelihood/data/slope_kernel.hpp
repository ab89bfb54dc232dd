#pragma once

#include <complex>
#include <cstddef>

namespace jointid::ident {

/// FRFs side by side: their parts and variances on a few neighbouring lines. All zero with variances of 1: no FRF.
struct FrfLanes {
  static constexpr std::size_t width = 8, most_lines = 9;

  struct Line {
    double re[width], im[width], variance_re[width], variance_im[width];
  };
  Line lines[most_lines];
};

/// What polynomials of degree d leave of 2d + 1 lines: orthonormal columns, and the lines' places w.
struct PolynomialRemainder {
  static constexpr std::size_t most_degree = FrfLanes::most_lines / 2;

  std::size_t degree = 0;
  double column[FrfLanes::most_lines][most_degree] = {};
  double power[FrfLanes::most_lines][most_degree + 1] = {};  ///< w^j

  std::size_t lines() const { return 2 * degree + 1; }
  std::size_t unknowns() const { return 2 * degree; }
};

/// q = 1 + Σ c_j w^j so that q H is nearly a polynomial: what it is off is its part along the columns that polynomials leave, whitened by
/// the errors, which go through the denominator `before`. Real and imaginary parts have weights of their own: where damping is small and
/// errors are in proportion to each part, the imaginary one is known far better, and has most of what a stretch changes. Adds the lower
/// triangle of the normal equations of all FRFs of `count` blocks, row by row: of the real and, after them, the imaginary parts of
/// c_1 … c_d; the last row is that of the right side.
void add_denominator_sums(const FrfLanes* blocks, std::size_t count, const PolynomialRemainder& off, const std::complex<double>* before,
                          double* sums);

}  // namespace jointid::ident

#include "ident/likelihood/data/slope_kernel.hpp"

#include <algorithm>
#include <cmath>

#include "base/kernel.hpp"

namespace jointid::ident {
namespace {

using Complex = std::complex<double>;

/// w^j times each column, by lines; and products of two columns.
template <std::size_t degree>
struct Coefficients {
  static constexpr std::size_t lines = 2 * degree + 1;

  double of[lines][degree + 1][degree], pair[lines][degree][degree];

  explicit Coefficients(const PolynomialRemainder& off) {
    for (std::size_t k = 0; k < lines; ++k) {
      for (std::size_t a = 0; a < degree; ++a) {
        for (std::size_t j = 0; j <= degree; ++j) of[k][j][a] = off.power[k][j] * off.column[k][a];
        for (std::size_t b = 0; b <= a; ++b) pair[k][a][b] = off.column[k][a] * off.column[k][b];
      }
    }
  }
};

/// Parts of `lanes` FRFs along the columns.
template <std::size_t lanes, std::size_t degree>
using Parts = Lanes<lanes>[degree + 1][degree];

/// L of C = L Lᵀ, which errors of these variances on the lines make of the parts along the columns: below the diagonal, and one over it.
/// All of these are 0 where C is singular.
template <std::size_t lanes, std::size_t degree>
struct Whitener {
  static constexpr double singular = 1e-13;  // of the variance, what the columns before leave of it

  Lanes<lanes> below[degree][degree], inverse[degree];

  JOINTID_INLINE Whitener(const Coefficients<degree>& by, const Lanes<lanes>* variance) {
    Lanes<lanes> is_regular = Lanes<lanes>{} + 1.0;
    for (std::size_t a = 0; a < degree; ++a) {
      for (std::size_t c = a; c < degree; ++c) {
        Lanes<lanes> sum{};
        for (std::size_t k = 0; k < 2 * degree + 1; ++k) sum += by.pair[k][c][a] * variance[k];
        below[c][a] = sum;
      }
    }
    for (std::size_t a = 0; a < degree; ++a) {
      Lanes<lanes> left = below[a][a];
      for (std::size_t b = 0; b < a; ++b) left -= below[a][b] * below[a][b];
      for (std::size_t l = 0; l < lanes; ++l) {
        const bool is_good = left[l] > singular * below[a][a][l];
        inverse[a][l] = is_good ? 1.0 / std::sqrt(left[l]) : 0.0;
        if (!is_good) is_regular[l] = 0.0;
      }
      for (std::size_t c = a + 1; c < degree; ++c) {
        for (std::size_t b = 0; b < a; ++b) below[c][a] -= below[c][b] * below[a][b];
        below[c][a] *= inverse[a];
      }
    }
    for (std::size_t a = 0; a < degree; ++a) inverse[a] *= is_regular;
  }

  JOINTID_INLINE void whiten(const Lanes<lanes>* parts, double sign, Lanes<lanes>* out) const {
    for (std::size_t a = 0; a < degree; ++a) {
      Lanes<lanes> left = sign * parts[a];
      for (std::size_t b = 0; b < a; ++b) left -= below[a][b] * out[b];
      out[a] = left * inverse[a];
    }
  }
};

/// Rows of one part of the FRFs, `own`; the imaginary parts of the coefficients bring the other one in.
template <std::size_t lanes, std::size_t degree>
JOINTID_INLINE void add_rows(const Whitener<lanes, degree>& whitener, const Parts<lanes, degree>& own, const Parts<lanes, degree>& other,
                             double sign, Lanes<lanes>* sums) {
  Lanes<lanes> row[2 * degree + 1][degree];
  for (std::size_t j = 1; j <= degree; ++j) {
    whitener.whiten(own[j], 1.0, row[j - 1]);
    whitener.whiten(other[j], sign, row[degree + j - 1]);
  }
  whitener.whiten(own[0], 1.0, row[2 * degree]);
  for (std::size_t i = 0; i <= 2 * degree; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      Lanes<lanes> sum = *sums;
      for (std::size_t a = 0; a < degree; ++a) sum += row[i][a] * row[j][a];
      *sums++ = sum;
    }
  }
}

/// Of the real and the imaginary part of q H on the lines. Parts without an error are not exact.
template <std::size_t lanes, std::size_t count>
JOINTID_INLINE void take_variances(const FrfLanes& block, std::size_t first, const Complex* q, Lanes<lanes>* re, Lanes<lanes>* im) {
  constexpr double least = 1e-12;  // of those of all lines
  Lanes<lanes> all{};
  for (std::size_t k = 0; k < count; ++k) {
    Lanes<lanes> of_re, of_im;
    load(block.lines[k].variance_re + first, of_re);
    load(block.lines[k].variance_im + first, of_im);
    const double own = q[k].real() * q[k].real(), other = q[k].imag() * q[k].imag();
    re[k] = own * of_re + other * of_im;
    im[k] = own * of_im + other * of_re;
    all += re[k] + im[k];
  }
  all *= least;
  for (std::size_t k = 0; k < count; ++k) {
    re[k] = re[k] > all ? re[k] : all;
    im[k] = im[k] > all ? im[k] : all;
  }
}

template <std::size_t lanes, std::size_t degree>
JOINTID_INLINE void take_parts(const FrfLanes& block, std::size_t first, const Coefficients<degree>& by, Parts<lanes, degree>& re,
                               Parts<lanes, degree>& im) {
  for (std::size_t j = 0; j <= degree; ++j) {
    Lanes<lanes> of_re[degree] = {}, of_im[degree] = {};
    for (std::size_t k = 0; k < 2 * degree + 1; ++k) {
      Lanes<lanes> value_re, value_im;
      load(block.lines[k].re + first, value_re);
      load(block.lines[k].im + first, value_im);
      for (std::size_t a = 0; a < degree; ++a) {
        of_re[a] += by.of[k][j][a] * value_re;
        of_im[a] += by.of[k][j][a] * value_im;
      }
    }
    for (std::size_t a = 0; a < degree; ++a) {
      re[j][a] = of_re[a];
      im[j][a] = of_im[a];
    }
  }
}

template <std::size_t lanes, std::size_t degree>
JOINTID_INLINE void add_of_degree(const FrfLanes* blocks, std::size_t count, const PolynomialRemainder& off, const Complex* before,
                                  double* sums) {
  constexpr std::size_t lines = 2 * degree + 1, numbers = lines * (lines + 1) / 2;
  const Coefficients<degree> by(off);
  Lanes<lanes> all[numbers] = {};
  for (const FrfLanes* block = blocks; block != blocks + count; ++block) {
    for (std::size_t first = 0; first < FrfLanes::width; first += lanes) {
      Lanes<lanes> variance_re[lines], variance_im[lines];
      Parts<lanes, degree> re, im;
      take_variances<lanes, lines>(*block, first, before, variance_re, variance_im);
      take_parts<lanes, degree>(*block, first, by, re, im);
      add_rows<lanes, degree>(Whitener<lanes, degree>(by, variance_re), re, im, -1.0, all);
      add_rows<lanes, degree>(Whitener<lanes, degree>(by, variance_im), im, re, 1.0, all);
    }
  }
  for (std::size_t i = 0; i < numbers; ++i) {
    for (std::size_t l = 0; l < lanes; ++l) sums[i] += all[i][l];
  }
}

template <std::size_t lanes>
JOINTID_INLINE void add_lanes(const FrfLanes* blocks, std::size_t count, const PolynomialRemainder& off, const Complex* before,
                              double* sums) {
  if (off.degree == 1) add_of_degree<lanes, 1>(blocks, count, off, before, sums);
  if (off.degree == 2) add_of_degree<lanes, 2>(blocks, count, off, before, sums);
  if (off.degree == 3) add_of_degree<lanes, 3>(blocks, count, off, before, sums);
  if (off.degree == 4) add_of_degree<lanes, 4>(blocks, count, off, before, sums);
}

}  // namespace

JOINTID_KERNEL_OF_LANES(void add_denominator_sums,
                        (const FrfLanes* blocks, std::size_t count, const PolynomialRemainder& off, const Complex* before, double* sums),
                        add_lanes, (blocks, count, off, before, sums))

}  // namespace jointid::ident

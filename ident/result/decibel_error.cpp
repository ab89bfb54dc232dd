#include "ident/result/decibel_error.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "base/kernel.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t width = 8;

/// log2 of a positive normal number to about 1e-14: mantissa m in [1/√2, √2), log m = 2 artanh((m−1)/(m+1)).
JOINTID_INLINE double fast_log2(double x) {
  constexpr std::uint64_t mantissa_mask = 0x000fffffffffffffULL;
  constexpr std::uint64_t half_root = 0x3fe6a09e667f3bcdULL;  // bits of 1/√2
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t shifted = bits - half_root;
  // The exponent e as a double without an integer conversion: e + 1024 in the low bits of 2^52.
  const std::uint64_t exponent = ((shifted >> 52) + 1024) & 0xfff;
  const double e = std::bit_cast<double>(0x4330000000000000ULL | exponent) - 4503599627370496.0 - 1024.0;
  const double m = std::bit_cast<double>((shifted & mantissa_mask) + half_root);
  const double s = (m - 1.0) / (m + 1.0);
  const double q = s * s;
  const double series =
      1.0 + q * (1.0 / 3 + q * (1.0 / 5 + q * (1.0 / 7 + q * (1.0 / 9 + q * (1.0 / 11 + q * (1.0 / 13 + q / 15))))));
  return e + 2.0 / std::numbers::ln2 * s * series;
}

/// `rows` rows of base − left·right against the measured rows; they share what is loaded of `right`.
template <std::size_t lanes, std::size_t rows>
JOINTID_INLINE void add_rows(const double* base, std::size_t base_stride, const double* left_re, const double* left_im,
                             const double* right_re, const double* right_im, std::size_t right_stride, std::size_t n,
                             const double* measured, std::size_t measured_stride, std::size_t columns, double least,
                             double& total, double& entries) {
  constexpr double tiny = 1e-300, huge = 1e300;
  double sum[lanes] = {}, count[lanes] = {};
  for (std::size_t c0 = 0; c0 < columns; c0 += lanes) {
    const std::size_t used = std::min(lanes, columns - c0);
    double base_re[rows][lanes] = {}, base_im[rows][lanes] = {}, m2[rows][lanes] = {};
    for (std::size_t r = 0; r < rows; ++r) {
      const double* b = base + 2 * (r * base_stride + c0);
      const double* m = measured + 2 * (r * measured_stride + c0);
      for (std::size_t c = 0; c < used; ++c) {
        base_re[r][c] = b[2 * c];
        base_im[r][c] = b[2 * c + 1];
        m2[r][c] = m[2 * c] * m[2 * c] + m[2 * c + 1] * m[2 * c + 1];
      }
    }
    Lanes<lanes> re[rows], im[rows];
    for (std::size_t r = 0; r < rows; ++r) {
      load(base_re[r], re[r]);
      load(base_im[r], im[r]);
    }
    // The rows of `right` are padded to whole panels.
    for (std::size_t k = 0; k < n; ++k) {
      Lanes<lanes> r_re, r_im;
      load(right_re + k * right_stride + c0, r_re);
      load(right_im + k * right_stride + c0, r_im);
      for (std::size_t r = 0; r < rows; ++r) {
        const double l_re = left_re[r * n + k], l_im = left_im[r * n + k];
        re[r] -= l_re * r_re - l_im * r_im;
        im[r] -= l_re * r_im + l_im * r_re;
      }
    }
    for (std::size_t r = 0; r < rows; ++r) {
      double p2[lanes];
      store(re[r] * re[r] + im[r] * im[r], p2);
#pragma omp simd
      for (std::size_t c = 0; c < lanes; ++c) {
        // Comparisons with NaN are false, so entries that were not measured count as unusable.
        const bool usable = (p2[c] > tiny) & (m2[r][c] > least) & (p2[c] < huge) & (m2[r][c] < huge);
        const double difference = fast_log2(usable ? p2[c] / m2[r][c] : 1.0);
        sum[c] += difference * difference;
        count[c] += usable ? 1.0 : 0.0;
      }
    }
  }
  for (std::size_t c = 0; c < lanes; ++c) {
    total += sum[c];
    entries += count[c];
  }
}

/// Largest |m|² of a row, of what was measured.
template <std::size_t lanes>
JOINTID_INLINE void raise_to_largest(const double* row, std::size_t columns, double* largest) {
  const auto raise = [](double re, double im, double& to) {
    const double square = re * re + im * im;
    to = square > to ? square : to;  // false for NaN
  };
  std::size_t c0 = 0;
  for (; c0 + lanes <= columns; c0 += lanes) {
#pragma omp simd
    for (std::size_t c = 0; c < lanes; ++c) raise(row[2 * (c0 + c)], row[2 * (c0 + c) + 1], largest[c]);
  }
  for (std::size_t c = c0; c < columns; ++c) raise(row[2 * c], row[2 * c + 1], largest[c - c0]);
}

template <std::size_t lanes>
JOINTID_INLINE void add_all_rows_of(const double* base, std::size_t base_stride, const double* left_re, const double* left_im,
                                    const double* right_re, const double* right_im, std::size_t right_stride, std::size_t n,
                                    const double* measured, std::size_t measured_stride, std::size_t rows, std::size_t columns,
                                    double& total, double& entries) {
  constexpr std::size_t together = 4;
  double squares[lanes] = {};
  for (std::size_t i = 0; i < rows; ++i) raise_to_largest<lanes>(measured + 2 * i * measured_stride, columns, squares);
  double largest = 0.0;
  for (const double square : squares) largest = square > largest ? square : largest;
  const double least = std::max(1e-300, largest * zero_level * zero_level);
  std::size_t r = 0;
  for (; r + together <= rows; r += together) {
    add_rows<lanes, together>(base + 2 * r * base_stride, base_stride, left_re + r * n, left_im + r * n, right_re, right_im,
                              right_stride, n, measured + 2 * r * measured_stride, measured_stride, columns, least, total,
                              entries);
  }
  for (; r < rows; ++r) {
    add_rows<lanes, 1>(base + 2 * r * base_stride, base_stride, left_re + r * n, left_im + r * n, right_re, right_im,
                       right_stride, n, measured + 2 * r * measured_stride, measured_stride, columns, least, total, entries);
  }
}

JOINTID_KERNEL_OF_LANES(void add_all_rows,
                        (const double* base, std::size_t base_stride, const double* left_re, const double* left_im,
                         const double* right_re, const double* right_im, std::size_t right_stride, std::size_t n,
                         const double* measured, std::size_t measured_stride, std::size_t rows, std::size_t columns,
                         double& total, double& entries),
                        add_all_rows_of,
                        (base, base_stride, left_re, left_im, right_re, right_im, right_stride, n, measured, measured_stride,
                         rows, columns, total, entries))

}  // namespace

std::size_t padded(std::size_t columns) { return (columns + width - 1) / width * width; }

void add_decibel_error(const minimise::View& base, const double* left_re, const double* left_im, const double* right_re,
                       const double* right_im, std::size_t n, const minimise::View& measured, DecibelError& error) {
  double total = 0.0, entries = 0.0;
  add_all_rows(reinterpret_cast<const double*>(base.data), base.stride, left_re, left_im, right_re, right_im,
               padded(base.columns), n, reinterpret_cast<const double*>(measured.data), measured.stride, base.rows, base.columns,
               total, entries);
  constexpr double db_per_octave = 10.0 * std::numbers::ln2 / std::numbers::ln10;  // of the squared modulus
  error.sum_of_squares += total * db_per_octave * db_per_octave;
  error.entries += static_cast<std::size_t>(entries);
}

}  // namespace jointid::ident

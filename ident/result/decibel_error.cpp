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
template <std::size_t rows>
JOINTID_INLINE void add_rows(const double* base, std::size_t base_stride, const double* left_re, const double* left_im,
                             const double* right_re, const double* right_im, std::size_t n, const double* measured,
                             std::size_t measured_stride, std::size_t columns, double least, double& total,
                             double& entries) {
  constexpr double tiny = 1e-300, huge = 1e300;
  double sum[width] = {}, count[width] = {};
  for (std::size_t c0 = 0; c0 < columns; c0 += width) {
    const std::size_t used = std::min(width, columns - c0);
    double re[rows][width] = {}, im[rows][width] = {}, m2[rows][width] = {};
    for (std::size_t r = 0; r < rows; ++r) {
      const double* b = base + 2 * (r * base_stride + c0);
      const double* m = measured + 2 * (r * measured_stride + c0);
      for (std::size_t c = 0; c < used; ++c) {
        re[r][c] = b[2 * c];
        im[r][c] = b[2 * c + 1];
        m2[r][c] = m[2 * c] * m[2 * c] + m[2 * c + 1] * m[2 * c + 1];
      }
    }
    // The rows of `right` are padded to whole panels.
    for (std::size_t k = 0; k < n; ++k) {
      const double* r_re = right_re + (k * padded(columns)) + c0;
      const double* r_im = right_im + (k * padded(columns)) + c0;
      for (std::size_t r = 0; r < rows; ++r) {
        const double l_re = left_re[r * n + k], l_im = left_im[r * n + k];
#pragma omp simd
        for (std::size_t c = 0; c < width; ++c) {
          re[r][c] -= l_re * r_re[c] - l_im * r_im[c];
          im[r][c] -= l_re * r_im[c] + l_im * r_re[c];
        }
      }
    }
    for (std::size_t r = 0; r < rows; ++r) {
#pragma omp simd
      for (std::size_t c = 0; c < width; ++c) {
        const double p2 = re[r][c] * re[r][c] + im[r][c] * im[r][c];
        // Comparisons with NaN are false, so entries that were not measured count as unusable.
        const bool usable = (p2 > tiny) & (m2[r][c] > least) & (p2 < huge) & (m2[r][c] < huge);
        const double difference = fast_log2(usable ? p2 / m2[r][c] : 1.0);
        sum[c] += difference * difference;
        count[c] += usable ? 1.0 : 0.0;
      }
    }
  }
  for (std::size_t c = 0; c < width; ++c) {
    total += sum[c];
    entries += count[c];
  }
}

JOINTID_KERNEL void add_all_rows(const double* base, std::size_t base_stride, const double* left_re,
                                 const double* left_im, const double* right_re, const double* right_im, std::size_t n,
                                 const double* measured, std::size_t measured_stride, std::size_t rows,
                                 std::size_t columns, double& total, double& entries) {
  constexpr std::size_t together = 4;
  double largest = 0.0;
  for (std::size_t i = 0; i < rows; ++i) {
    const double* row = measured + 2 * i * measured_stride;
    for (std::size_t c = 0; c < columns; ++c) {
      const double square = row[2 * c] * row[2 * c] + row[2 * c + 1] * row[2 * c + 1];
      largest = square > largest ? square : largest;  // false for NaN
    }
  }
  const double least = std::max(1e-300, largest * zero_level * zero_level);
  std::size_t r = 0;
  for (; r + together <= rows; r += together) {
    add_rows<together>(base + 2 * r * base_stride, base_stride, left_re + r * n, left_im + r * n, right_re, right_im, n,
                       measured + 2 * r * measured_stride, measured_stride, columns, least, total, entries);
  }
  for (; r < rows; ++r) {
    add_rows<1>(base + 2 * r * base_stride, base_stride, left_re + r * n, left_im + r * n, right_re, right_im, n,
                measured + 2 * r * measured_stride, measured_stride, columns, least, total, entries);
  }
}

}  // namespace

std::size_t padded(std::size_t columns) { return (columns + width - 1) / width * width; }

void add_decibel_error(const minimise::View& base, const double* left_re, const double* left_im, const double* right_re,
                       const double* right_im, std::size_t n, const minimise::View& measured, DecibelError& error) {
  double total = 0.0, entries = 0.0;
  add_all_rows(reinterpret_cast<const double*>(base.data), base.stride, left_re, left_im, right_re, right_im, n,
               reinterpret_cast<const double*>(measured.data), measured.stride, base.rows, base.columns, total, entries);
  constexpr double db_per_octave = 10.0 * std::numbers::ln2 / std::numbers::ln10;  // of the squared modulus
  error.sum_of_squares += total * db_per_octave * db_per_octave;
  error.entries += static_cast<std::size_t>(entries);
}

}  // namespace jointid::ident

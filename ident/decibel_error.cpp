#include "ident/decibel_error.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "ident/kernel.hpp"

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

/// One row of base − left·right against the measured row.
JOINTID_KERNEL void add_row(const double* base, const double* left_re, const double* left_im, const double* right_re,
                            const double* right_im, std::size_t n, const double* measured, std::size_t columns,
                            double& total, double& entries) {
  constexpr double tiny = 1e-300;
  double sum[width] = {}, count[width] = {};
  for (std::size_t c0 = 0; c0 < columns; c0 += width) {
    const std::size_t used = std::min(width, columns - c0);
    double re[width] = {}, im[width] = {}, m2[width] = {};
    for (std::size_t c = 0; c < used; ++c) {
      re[c] = base[2 * (c0 + c)];
      im[c] = base[2 * (c0 + c) + 1];
      const double a = measured[2 * (c0 + c)], b = measured[2 * (c0 + c) + 1];
      m2[c] = a * a + b * b;
    }
    for (std::size_t k = 0; k < n; ++k) {
      const double* r_re = right_re + k * columns + c0;
      const double* r_im = right_im + k * columns + c0;
      if (used == width) {
#pragma omp simd
        for (std::size_t c = 0; c < width; ++c) {
          re[c] -= left_re[k] * r_re[c] - left_im[k] * r_im[c];
          im[c] -= left_re[k] * r_im[c] + left_im[k] * r_re[c];
        }
      } else {
        for (std::size_t c = 0; c < used; ++c) {
          re[c] -= left_re[k] * r_re[c] - left_im[k] * r_im[c];
          im[c] -= left_re[k] * r_im[c] + left_im[k] * r_re[c];
        }
      }
    }
#pragma omp simd
    for (std::size_t c = 0; c < width; ++c) {
      const double p2 = re[c] * re[c] + im[c] * im[c];
      // Comparisons with NaN are false, so entries that were not measured count as unusable.
      const double usable = (p2 > tiny) & (m2[c] > tiny) & (p2 < 1e300) & (m2[c] < 1e300) ? 1.0 : 0.0;
      const double ratio = usable != 0.0 ? p2 / m2[c] : 1.0;
      const double difference = fast_log2(ratio);
      sum[c] += difference * difference;
      count[c] += usable;
    }
  }
  for (std::size_t c = 0; c < width; ++c) {
    total += sum[c];
    entries += count[c];
  }
}

}  // namespace

void add_decibel_error(const View& base, const double* left_re, const double* left_im, const double* right_re,
                       const double* right_im, std::size_t n, const View& measured, DecibelError& error) {
  double total = 0.0, entries = 0.0;
  for (std::size_t r = 0; r < base.rows; ++r) {
    add_row(reinterpret_cast<const double*>(base.data + r * base.stride), left_re + r * n, left_im + r * n, right_re,
            right_im, n, reinterpret_cast<const double*>(measured.data + r * measured.stride), base.columns, total,
            entries);
  }
  constexpr double db_per_octave = 10.0 * std::numbers::ln2 / std::numbers::ln10;  // of the squared modulus
  error.sum_of_squares += total * db_per_octave * db_per_octave;
  error.entries += static_cast<std::size_t>(entries);
}

}  // namespace jointid::ident

#pragma once

#include <cstddef>

namespace jointid::minimise {

/// Thin QR of the complex m×n matrix x by Householder reflections I − τvvᴴ with real τ. Matrices are split into real and
/// imaginary parts, columns contiguous and `m` apart. Afterwards q holds the first min(m,n) columns of Q, and the upper part
/// of x holds R; tau is scratch for min(m,n) numbers. Zero columns are no exception: Q stays orthonormal.
void thin_qr(double* x_re, double* x_im, std::size_t m, std::size_t n, double* q_re, double* q_im, double* tau);

}  // namespace jointid::minimise

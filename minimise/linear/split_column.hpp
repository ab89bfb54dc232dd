#pragma once

#include <cstddef>

#include "base/kernel.hpp"

namespace jointid::minimise {

/// A complex column as two real arrays.
struct Column {
  double* re;
  double* im;
};

/// uᴴv over `count` elements.
JOINTID_INLINE void dot(const Column& u, const Column& v, std::size_t count, double& re, double& im) {
  double sum_re = 0.0, sum_im = 0.0;
#pragma omp simd reduction(+ : sum_re, sum_im)
  for (std::size_t i = 0; i < count; ++i) {
    sum_re += u.re[i] * v.re[i] + u.im[i] * v.im[i];
    sum_im += u.re[i] * v.im[i] - u.im[i] * v.re[i];
  }
  re = sum_re;
  im = sum_im;
}

/// v −= (re + i·im) u.
JOINTID_INLINE void subtract(const Column& u, double re, double im, std::size_t count, const Column& v) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    v.re[i] -= u.re[i] * re - u.im[i] * im;
    v.im[i] -= u.re[i] * im + u.im[i] * re;
  }
}

}  // namespace jointid::minimise

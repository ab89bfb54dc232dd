#include "ident/likelihood/rows/normal_kernels.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/kernel.hpp"

namespace jointid::ident {
namespace {

/// M columns of C, N times `lanes` numbers of each.
template <std::size_t lanes, std::size_t M, std::size_t N, bool add>
JOINTID_INLINE void products(double* c, std::size_t stride, ConstRows a, ConstRows b, std::size_t count) {
  Lanes<lanes> sum[M][N];
  for (std::size_t i = 0; i < M; ++i) {
    for (std::size_t j = 0; j < N; ++j) load(c + i * stride + lanes * j, sum[i][j]);
  }
  for (std::size_t r = 0; r < count; ++r, a.data += a.stride, b.data += b.stride) {
    Lanes<lanes> right[N];
    for (std::size_t j = 0; j < N; ++j) load(b.data + lanes * j, right[j]);
    for (std::size_t i = 0; i < M; ++i) {
      const double left = add ? a.data[i] : -a.data[i];
      for (std::size_t j = 0; j < N; ++j) sum[i][j] += left * right[j];
    }
  }
  for (std::size_t i = 0; i < M; ++i) {
    for (std::size_t j = 0; j < N; ++j) store(sum[i][j], c + i * stride + lanes * j);
  }
}

template <std::size_t lanes, std::size_t M, bool add>
JOINTID_INLINE void column_products(double* c, std::size_t stride, ConstRows a, ConstRows b, std::size_t n, std::size_t count) {
  std::size_t j = 0;
  for (; j + 2 * lanes <= n; j += 2 * lanes) products<lanes, M, 2, add>(c + j, stride, a, {b.data + j, b.stride}, count);
  if (j < n) products<lanes, M, 1, add>(c + j, stride, a, {b.data + j, b.stride}, count);
}

template <std::size_t lanes, bool add>
JOINTID_INLINE void all_products(double* c, std::size_t stride, ConstRows a, std::size_t m, ConstRows b, std::size_t n,
                                 std::size_t count) {
  std::size_t i = 0;
  for (; i + 4 <= m; i += 4) column_products<lanes, 4, add>(c + i * stride, stride, {a.data + i, a.stride}, b, n, count);
  for (; i < m; ++i) column_products<lanes, 1, add>(c + i * stride, stride, {a.data + i, a.stride}, b, n, count);
}

/// A panel of columns, all of whose rows below are divided by its factor.
JOINTID_INLINE bool factor_panel(double* matrix, std::size_t stride, std::size_t first, std::size_t last, std::size_t size) {
  for (std::size_t j = first; j < last; ++j) {
    double* const column = matrix + j * stride;
    if (!(column[j] > 0.0) || !std::isfinite(column[j])) return false;
    const double scale = 1.0 / std::sqrt(column[j]);
#pragma omp simd
    for (std::size_t i = j; i < size; ++i) column[i] *= scale;
    for (std::size_t k = j + 1; k < last; ++k) {
      double* const other = matrix + k * stride;
      const double by = column[k];
#pragma omp simd
      for (std::size_t i = k; i < size; ++i) other[i] -= by * column[i];
    }
  }
  return true;
}

/// U⁻¹W of M rows from `first` on, `lanes` columns of those after them being there.
template <std::size_t lanes, std::size_t M>
JOINTID_INLINE void subtract_solved(const double* matrix, std::size_t stride, std::size_t v, std::size_t first, std::size_t width,
                                    double* out) {
  Lanes<lanes> sum[M], other;
  for (std::size_t m = 0; m < M; ++m) load(out + (first + m) * width, sum[m]);
  for (std::size_t i = first + M; i < v; ++i) {
    load(out + i * width, other);
    for (std::size_t m = 0; m < M; ++m) sum[m] -= matrix[(first + m) * stride + i] * other;
  }
  for (std::size_t m = M; m-- > 0;) {
    const double* const column = matrix + (first + m) * stride;
    for (std::size_t i = m + 1; i < M; ++i) sum[m] -= column[first + i] * sum[i];
    sum[m] *= 1.0 / column[first + m];
    store(sum[m], out + (first + m) * width);
  }
}

template <std::size_t lanes>
JOINTID_INLINE void add_lanes(double* c, std::size_t stride, ConstRows a, std::size_t m, ConstRows b, std::size_t n, std::size_t count) {
  all_products<lanes, true>(c, stride, a, m, b, n, count);
}

template <std::size_t lanes>
JOINTID_INLINE bool eliminate_lanes(double* matrix, std::size_t stride, std::size_t v, std::size_t size) {
  const std::size_t panel = v < 128 ? 8 : 32;
  for (std::size_t first = 0; first < v; first += panel) {
    const std::size_t last = std::min(v, first + panel);
    if (!factor_panel(matrix, stride, first, last, size)) return false;
    for (std::size_t i = last; i < size; i += 4) {
      const ConstRows rows{matrix + first * stride + i, stride};
      all_products<lanes, false>(matrix + i * stride + i, stride, rows, std::min<std::size_t>(4, size - i), rows, widths_of(size - i),
                                 last - first);
    }
  }
  return true;
}

template <std::size_t lanes>
JOINTID_INLINE void solve_lanes(const double* matrix, std::size_t stride, std::size_t v, std::size_t size, double* out) {
  const std::size_t right = size - v, width = widths_of(right);
  for (std::size_t j = 0; j < v; ++j) {
    std::memcpy(out + j * width, matrix + j * stride + v, right * sizeof(double));
    std::fill(out + j * width + right, out + (j + 1) * width, 0.0);
  }
  for (std::size_t last = v; last > 0;) {
    const std::size_t count = last % 4 == 0 ? 4 : last % 4, first = last - count;
    for (std::size_t k = 0; k < width; k += lanes) {
      if (count == 4) {
        subtract_solved<lanes, 4>(matrix, stride, v, first, width, out + k);
      } else {
        for (std::size_t j = last; j-- > first;) subtract_solved<lanes, 1>(matrix, stride, v, j, width, out + k);
      }
    }
    last = first;
  }
}

}  // namespace

JOINTID_KERNEL_OF_LANES(void add_products,
                        (double* c, std::size_t stride, ConstRows a, std::size_t m, ConstRows b, std::size_t n, std::size_t count),
                        add_lanes, (c, stride, a, m, b, n, count))
JOINTID_KERNEL_OF_LANES(bool eliminate, (double* matrix, std::size_t stride, std::size_t v, std::size_t size), eliminate_lanes,
                        (matrix, stride, v, size))
JOINTID_KERNEL_OF_LANES(void solve_eliminated,
                        (const double* matrix, std::size_t stride, std::size_t v, std::size_t size, double* out), solve_lanes,
                        (matrix, stride, v, size, out))

JOINTID_KERNEL void solve_by_factor(const double* matrix, std::size_t stride, std::size_t v, double* x) {
  for (std::size_t j = 0; j < v; ++j) {
    const double* const column = matrix + j * stride;
    const double value = x[j] /= column[j];
#pragma omp simd
    for (std::size_t i = j + 1; i < v; ++i) x[i] -= value * column[i];
  }
  for (std::size_t j = v; j-- > 0;) {
    const double* const column = matrix + j * stride;
    double sum = 0.0;
#pragma omp simd reduction(+ : sum)
    for (std::size_t i = j + 1; i < v; ++i) sum += column[i] * x[i];
    x[j] = (x[j] - sum) / column[j];
  }
}

}  // namespace jointid::ident

#include "dense/gram.hpp"

#include "base/kernel.hpp"

namespace jointid::dense {
namespace {

using Four = Lanes<4>;

JOINTID_INLINE double sum_of(const Four& v) { return (v[0] + v[2]) + (v[1] + v[3]); }

/// c[i, j] += the products of columns i … i + 3 with j and j + 1, over the rows.
JOINTID_INLINE void add_block(const double* a, std::size_t rows, std::size_t stride, std::size_t i, std::size_t j,
                              std::size_t columns, double* c) {
  const double *l0 = a + i * stride, *l1 = l0 + stride, *l2 = l1 + stride, *l3 = l2 + stride;
  const double *r0 = a + j * stride, *r1 = r0 + stride;
  Four s00 = {}, s10 = {}, s20 = {}, s30 = {}, s01 = {}, s11 = {}, s21 = {}, s31 = {};
  std::size_t r = 0;
  for (; r + 4 <= rows; r += 4) {
    Four x, y, p, q;
    load(r0 + r, x);
    load(r1 + r, y);
    load(l0 + r, p);
    load(l1 + r, q);
    s00 += p * x;
    s01 += p * y;
    s10 += q * x;
    s11 += q * y;
    load(l2 + r, p);
    load(l3 + r, q);
    s20 += p * x;
    s21 += p * y;
    s30 += q * x;
    s31 += q * y;
  }
  double own[2][4] = {{sum_of(s00), sum_of(s10), sum_of(s20), sum_of(s30)}, {sum_of(s01), sum_of(s11), sum_of(s21), sum_of(s31)}};
  for (; r < rows; ++r) {
    const double left[4] = {l0[r], l1[r], l2[r], l3[r]}, right[2] = {r0[r], r1[r]};
    for (int m = 0; m < 2; ++m) {
      for (int k = 0; k < 4; ++k) own[m][k] += left[k] * right[m];
    }
  }
  for (std::size_t m = 0; m < 2; ++m) {
    for (std::size_t k = 0; k < 4; ++k) c[i + k + (j + m) * columns] += own[m][k];
  }
}

JOINTID_INLINE void add_one(const double* a, std::size_t rows, std::size_t stride, std::size_t i, std::size_t j,
                            std::size_t columns, double* c) {
  const double *left = a + i * stride, *right = a + j * stride;
  double sum = 0.0;
  for (std::size_t r = 0; r < rows; ++r) sum += left[r] * right[r];
  c[i + j * columns] += sum;
}

}  // namespace

JOINTID_KERNEL void add_gram(const double* a, std::size_t rows, std::size_t columns, std::size_t stride, double* c) {
  for (std::size_t j = 0; j < columns; j += 2) {
    const bool pair = j + 1 < columns;
    std::size_t i = j;
    if (pair) {
      for (; i + 4 <= columns; i += 4) add_block(a, rows, stride, i, j, columns, c);
    }
    for (; i < columns; ++i) {
      add_one(a, rows, stride, i, j, columns, c);
      if (pair && i > j) add_one(a, rows, stride, i, j + 1, columns, c);
    }
  }
}

}  // namespace jointid::dense

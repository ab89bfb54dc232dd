#include "dense/gram.hpp"

#include <algorithm>

#include "base/kernel.hpp"

namespace jointid::dense {
namespace {

constexpr std::size_t rows_at_once = 512;  ///< of six columns in the cache nearest to the processor

/// So many rows of columns that lie `stride` apart.
struct Columns {
  const double* first;
  std::size_t count, stride;

  JOINTID_INLINE const double* at(std::size_t column, std::size_t row) const { return first + column * stride + row; }
};

template <std::size_t lanes>
JOINTID_INLINE double sum_of(const Lanes<lanes>& v) {
  double sum = 0.0;
  for (std::size_t k = 0; k < lanes; ++k) sum += v[k];
  return sum;
}

/// c[i, j] += the products of columns i … i + 3 of a with j and j + 1 of b, over some rows.
template <std::size_t lanes>
JOINTID_INLINE void add_block(const Columns& a, std::size_t i, const Columns& b, std::size_t j, std::size_t row, std::size_t end,
                              double* c) {
  const double *l0 = a.at(i, 0), *l1 = a.at(i + 1, 0), *l2 = a.at(i + 2, 0), *l3 = a.at(i + 3, 0);
  const double *r0 = b.at(j, 0), *r1 = b.at(j + 1, 0);
  Lanes<lanes> s00 = {}, s10 = {}, s20 = {}, s30 = {}, s01 = {}, s11 = {}, s21 = {}, s31 = {};
  std::size_t r = row;
  for (; r + lanes <= end; r += lanes) {
    Lanes<lanes> x, y, p, q;
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
  double own[2][4] = {{sum_of<lanes>(s00), sum_of<lanes>(s10), sum_of<lanes>(s20), sum_of<lanes>(s30)},
                      {sum_of<lanes>(s01), sum_of<lanes>(s11), sum_of<lanes>(s21), sum_of<lanes>(s31)}};
  for (; r < end; ++r) {
    const double left[4] = {l0[r], l1[r], l2[r], l3[r]}, right[2] = {r0[r], r1[r]};
    for (int m = 0; m < 2; ++m) {
      for (int k = 0; k < 4; ++k) own[m][k] += left[k] * right[m];
    }
  }
  for (std::size_t m = 0; m < 2; ++m) {
    for (std::size_t k = 0; k < 4; ++k) c[i + k + (j + m) * a.count] += own[m][k];
  }
}

template <std::size_t lanes>
JOINTID_INLINE void add_one(const Columns& a, std::size_t i, const Columns& b, std::size_t j, std::size_t row, std::size_t end,
                            double* c) {
  const double *left = a.at(i, 0), *right = b.at(j, 0);
  Lanes<lanes> even = {}, odd = {};
  std::size_t r = row;
  for (; r + 2 * lanes <= end; r += 2 * lanes) {
    Lanes<lanes> p, q, x, y;
    load(left + r, p);
    load(right + r, x);
    load(left + r + lanes, q);
    load(right + r + lanes, y);
    even += p * x;
    odd += q * y;
  }
  double sum = sum_of<lanes>(even + odd);
  for (; r < end; ++r) sum += left[r] * right[r];
  c[i + j * a.count] += sum;
}

/// C += AᵀB; `lower`: at least on and below the diagonal.
template <std::size_t lanes>
JOINTID_INLINE void add_products(const Columns& a, const Columns& b, std::size_t rows, bool lower, double* c) {
  for (std::size_t row = 0; row < rows; row += rows_at_once) {
    const std::size_t end = std::min(rows, row + rows_at_once);
    for (std::size_t j = 0; j < b.count; j += 2) {
      const bool pair = j + 1 < b.count;
      std::size_t i = lower ? j : 0;
      if (pair) {
        for (; i + 4 <= a.count; i += 4) add_block<lanes>(a, i, b, j, row, end, c);
      }
      for (; i < a.count; ++i) {
        add_one<lanes>(a, i, b, j, row, end, c);
        if (pair && !(lower && i == j)) add_one<lanes>(a, i, b, j + 1, row, end, c);
      }
    }
  }
}

JOINTID_KERNEL_OF_LANES(void add_by_lanes, (const Columns& a, const Columns& b, std::size_t rows, bool lower, double* c), add_products,
                        (a, b, rows, lower, c))

}  // namespace

void add_gram(const double* a, std::size_t rows, std::size_t columns, std::size_t stride, double* c) {
  const Columns of{a, columns, stride};
  add_by_lanes(of, of, rows, true, c);
}

void add_cross(const double* a, std::size_t columns_a, const double* b, std::size_t columns_b, std::size_t rows, double* c) {
  add_by_lanes({a, columns_a, rows}, {b, columns_b, rows}, rows, false, c);
}

}  // namespace jointid::dense

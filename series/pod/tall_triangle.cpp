#include "series/pod/tall_triangle.hpp"

#include <algorithm>
#include <cmath>

#include "base/kernel.hpp"

namespace jointid::series {
namespace {

constexpr std::size_t panel = 8;       ///< columns
constexpr std::size_t most_rows = 256;  ///< gathered before they are taken in: the panels of 64 columns lie near the processor

using Square = double[panel][panel];

/// H = I − τvvᵀ, v = (1, scale · x), that takes a column (alpha, x) with |x|² = below to (beta, 0).
struct Reflection {
  double beta, scale, tau;
};
JOINTID_INLINE Reflection reflection(double alpha, double below) {
  if (below == 0.0) return {alpha, 1.0, 0.0};
  const double beta = -std::copysign(std::sqrt(alpha * alpha + below), alpha);
  return {beta, 1.0 / (alpha - beta), (beta - alpha) / beta};
}

/// sum += AᵀB of two panels.
JOINTID_INLINE void add_product(const double* a, const double* b, std::size_t rows, Square& sum) {
  for (std::size_t i = 0; i < rows; ++i) {
    const double *left = a + i * panel, *right = b + i * panel;
#pragma GCC unroll 8
    for (std::size_t r = 0; r < panel; ++r) {
#pragma omp simd
      for (std::size_t j = 0; j < panel; ++j) sum[r][j] += left[r] * right[j];
    }
  }
}

/// B −= AW.
JOINTID_INLINE void subtract_product(const double* a, double* b, std::size_t rows, const Square& w) {
  for (std::size_t i = 0; i < rows; ++i) {
    const double* left = a + i * panel;
    double* row = b + i * panel;
    double rest[panel];
#pragma omp simd
    for (std::size_t j = 0; j < panel; ++j) rest[j] = row[j];
#pragma GCC unroll 8
    for (std::size_t r = 0; r < panel; ++r) {
#pragma omp simd
      for (std::size_t j = 0; j < panel; ++j) rest[j] -= left[r] * w[r][j];
    }
#pragma omp simd
    for (std::size_t j = 0; j < panel; ++j) row[j] = rest[j];
  }
}

/// row ← row · factor − scale · row_k · w for all rows of a panel; returns in `sums` the products of the column `next` with all.
JOINTID_INLINE void update_panel(double* x, std::size_t rows, std::size_t k, double scale, const double (&factor)[panel],
                                        const double (&w)[panel], std::size_t next, double (&sums)[panel]) {
  constexpr std::size_t chains = 4;  // side by side: one addition need not wait for the last
  double sum[chains][panel] = {};
  const double next_factor = factor[next], next_w = w[next];
  const auto one = [&](double* row, double(&to)[panel]) {
    const double v = row[k] * scale, left = row[next] * next_factor - v * next_w;
#pragma omp simd
    for (std::size_t j = 0; j < panel; ++j) {
      const double value = row[j] * factor[j] - v * w[j];
      row[j] = value;
      to[j] += left * value;
    }
  };
  std::size_t i = 0;
  for (; i + chains <= rows; i += chains) {
#pragma GCC unroll 4
    for (std::size_t c = 0; c < chains; ++c) one(x + (i + c) * panel, sum[c]);
  }
  for (; i < rows; ++i) one(x + i * panel, sum[0]);
  for (std::size_t j = 0; j < panel; ++j) sums[j] = (sum[0][j] + sum[1][j]) + (sum[2][j] + sum[3][j]);
}

/// Reflects the columns of a panel x below the diagonal square r of the triangle one after another: x becomes the lower part of V,
/// whose upper part is the identity; t of I − VTVᵀ, their product.
JOINTID_INLINE void reflect_panel(double* r, std::size_t stride, double* x, std::size_t rows, Square& t) {
  constexpr double zeros[panel] = {}, unit[panel] = {1, 1, 1, 1, 1, 1, 1, 1};
  double sums[panel], taus[panel];
  update_panel(x, rows, 0, 0.0, unit, zeros, 0, sums);
  for (std::size_t k = 0; k < panel; ++k) {
    double* top = r + k * stride;
    const Reflection h = reflection(top[k], sums[k]);
    double factor[panel], w[panel];
    for (std::size_t j = 0; j < panel; ++j) {
      factor[j] = j == k ? h.scale : 1.0;
      w[j] = j > k ? h.tau * (top[j] + h.scale * sums[j]) : 0.0;
      if (j > k) top[j] -= w[j];
    }
    top[k] = h.beta;
    taus[k] = h.tau;
    update_panel(x, rows, k, h.scale, factor, w, std::min(k + 1, panel - 1), sums);
  }
  Square products = {};
  add_product(x, x, rows, products);
  for (std::size_t j = 0; j < panel; ++j) {
    for (std::size_t i = 0; i < panel; ++i) {
      double sum = 0.0;
      for (std::size_t k = i; k < j; ++k) sum += t[i][k] * products[k][j];
      t[i][j] = i < j ? -taus[j] * sum : i == j ? taus[j] : 0.0;
    }
  }
}

/// Applies (I − VTVᵀ)ᵀ to a square of the triangle and the panel x below it.
JOINTID_INLINE void apply(const double* v, const Square& t, double* r, std::size_t stride, double* x, std::size_t rows) {
  Square product, w = {};
  for (std::size_t i = 0; i < panel; ++i) {
    for (std::size_t j = 0; j < panel; ++j) product[i][j] = r[i * stride + j];
  }
  add_product(v, x, rows, product);
  for (std::size_t i = 0; i < panel; ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
#pragma omp simd
      for (std::size_t j = 0; j < panel; ++j) w[i][j] += t[k][i] * product[k][j];
    }
    for (std::size_t j = 0; j < panel; ++j) r[i * stride + j] -= w[i][j];
  }
  subtract_product(v, x, rows, w);
}

/// R of [R; X], R [width, width], X in panels, which are destroyed.
JOINTID_KERNEL void take_in(double* r, double* x, std::size_t rows, std::size_t width) {
  Square t;
  for (std::size_t k = 0; k < width; k += panel) {
    double* v = x + k * rows;
    reflect_panel(r + k * width + k, width, v, rows, t);
    for (std::size_t c = k + panel; c < width; c += panel) apply(v, t, r + k * width + c, width, x + c * rows, rows);
  }
}

/// Reflects the column of ones onto the corner and applies that to the row `top` and the panels.
JOINTID_KERNEL void take_ones_in(double& corner, double* top, const double* ones, double* x, std::size_t rows,
                                        std::size_t width) {
  double below = 0.0;
  for (std::size_t i = 0; i < rows; ++i) below += ones[i] * ones[i];
  const Reflection h = reflection(corner, below);
  corner = h.beta;
  for (std::size_t k = 0; k < width; k += panel) {
    double sums[panel] = {}, w[panel];
    double* block = x + k * rows;
    for (std::size_t i = 0; i < rows; ++i) {
#pragma omp simd
      for (std::size_t j = 0; j < panel; ++j) sums[j] += ones[i] * block[i * panel + j];
    }
    for (std::size_t j = 0; j < panel; ++j) {
      w[j] = h.tau * (top[k + j] + h.scale * sums[j]);
      top[k + j] -= w[j];
    }
    for (std::size_t i = 0; i < rows; ++i) {
      const double v = h.scale * ones[i];
#pragma omp simd
      for (std::size_t j = 0; j < panel; ++j) block[i * panel + j] -= v * w[j];
    }
  }
}

/// Products with 0 are 0, or not a number.
JOINTID_KERNEL bool finite(const double* row, std::size_t count) {
  double sum = 0.0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t j = 0; j < count; ++j) sum += row[j] * 0.0;
  return sum == 0.0;
}

}  // namespace

TallTriangle::TallTriangle(std::size_t columns)
    : columns_(columns),
      width_((columns + panel - 1) / panel * panel),
      top_(width_, 0.0),
      triangle_(width_ * width_, 0.0),
      ones_(most_rows, 0.0),
      panels_(most_rows * width_, 0.0) {}

bool TallTriangle::push(double one, const double* row) {
  if (!finite(row, columns_)) return false;
  if (count_ == most_rows) flush();
  ones_[count_] = one;
  for (std::size_t k = 0; k < columns_; k += panel) {
    double* to = panels_.data() + k * most_rows + count_ * panel;
    std::copy_n(row + k, std::min(panel, columns_ - k), to);
  }
  ++count_;
  return true;
}

void TallTriangle::flush() {
  if (count_ == 0) return;
  // The panels of a block that is not full move together.
  for (std::size_t k = panel; k < width_ && count_ < most_rows; k += panel)
    std::copy_n(panels_.data() + k * most_rows, count_ * panel, panels_.data() + k * count_);
  take_ones_in(corner_, top_.data(), ones_.data(), panels_.data(), count_, width_);
  take_in(triangle_.data(), panels_.data(), count_, width_);
  if (width_ > columns_) std::fill(panels_.begin(), panels_.end(), 0.0);  // columns that pad the last panel stay zero
  count_ = 0;
}

}  // namespace jointid::series

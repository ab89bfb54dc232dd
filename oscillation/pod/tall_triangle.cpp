#include "oscillation/pod/tall_triangle.hpp"

#include <algorithm>
#include <cmath>

#include "base/kernel.hpp"

namespace jointid::oscillation {
namespace {

constexpr std::size_t panel = 8;        ///< columns
constexpr std::size_t most_rows = 256;  ///< gathered before they are taken in: the panels of 64 columns lie near the processor
constexpr std::size_t panel_size = (most_rows + 8) * panel;  ///< rows of different panels do not fall on the same places of a cache

using Square = double[panel][panel];

/// Squares below it have lost digits: what is so small is nothing.
constexpr double least_square = 1e-290;

/// H = I − γuuᵀ, u = (head, x), that takes a column (alpha, x) with |x|² = below to (beta, 0). u is not scaled to a head of 1, so
/// that the column x stays as it is.
struct Reflection {
  double beta, head, gamma;
};
JOINTID_INLINE Reflection reflection(double alpha, double below) {
  if (below < least_square) return {alpha, 1.0, 0.0};
  const double beta = -std::copysign(std::sqrt(alpha * alpha + below), alpha), head = alpha - beta;
  return {beta, head, -1.0 / (beta * head)};
}

/// A row of a panel.
template <std::size_t lanes>
struct Row {
  Lanes<lanes> part[panel / lanes];

  JOINTID_INLINE void load_from(const double* from) {
    for (std::size_t p = 0; p < panel / lanes; ++p) load(from + p * lanes, part[p]);
  }
  JOINTID_INLINE void store_to(double* to) const {
    for (std::size_t p = 0; p < panel / lanes; ++p) store(part[p], to + p * lanes);
  }
  JOINTID_INLINE void add(double factor, const Row& other) {
    for (std::size_t p = 0; p < panel / lanes; ++p) part[p] += factor * other.part[p];
  }
  template <int column>
  JOINTID_INLINE double at() const {
    return part[column / lanes][column % lanes];
  }
};

/// sum += AᵀB of two panels.
template <std::size_t lanes>
JOINTID_INLINE void add_product(const double* a, const double* b, std::size_t rows, Square& sum) {
  for (std::size_t first = 0; first < panel; first += lanes) {
    Row<lanes> sums[lanes];
    for (std::size_t r = 0; r < lanes; ++r) sums[r].load_from(sum[first + r]);
    for (std::size_t i = 0; i < rows; ++i) {
      Row<lanes> right;
      right.load_from(b + i * panel);
#pragma GCC unroll 8
      for (std::size_t r = 0; r < lanes; ++r) sums[r].add(a[i * panel + first + r], right);
    }
    for (std::size_t r = 0; r < lanes; ++r) sums[r].store_to(sum[first + r]);
  }
}

/// B −= AW.
template <std::size_t lanes>
JOINTID_INLINE void subtract_product(const double* a, double* b, std::size_t rows, const Square& w) {
  for (std::size_t i = 0; i < rows; ++i) {
    Row<lanes> rest;
    rest.load_from(b + i * panel);
#pragma GCC unroll 8
    for (std::size_t r = 0; r < panel; ++r) {
      Row<lanes> other;
      other.load_from(w[r]);
      rest.add(-a[i * panel + r], other);
    }
    rest.store_to(b + i * panel);
  }
}

/// Calls one(row, sum) for all rows of a panel with sums side by side, since one addition need not wait for the last, and adds these.
template <std::size_t lanes, class One>
JOINTID_INLINE void sum_rows(double* x, std::size_t rows, const One& one, double (&sums)[panel]) {
  constexpr std::size_t chains = 4;
  Row<lanes> sum[chains] = {};
  std::size_t i = 0;
  for (; i + chains <= rows; i += chains) {
#pragma GCC unroll 4
    for (std::size_t c = 0; c < chains; ++c) one(x + (i + c) * panel, sum[c]);
  }
  for (; i < rows; ++i) one(x + i * panel, sum[0]);
  sum[0].add(1.0, sum[1]);
  sum[2].add(1.0, sum[3]);
  sum[0].add(1.0, sum[2]);
  sum[0].store_to(sums);
}

/// sums ← products of the first column of a panel with all.
template <std::size_t lanes>
JOINTID_INLINE void first_sums(double* x, std::size_t rows, double (&sums)[panel]) {
  const auto one = [](const double* row, Row<lanes>& to) {
    Row<lanes> value;
    value.load_from(row);
    to.add(row[0], value);
  };
  sum_rows<lanes>(x, rows, one, sums);
}

/// row ← row − row_k w for all rows of a panel; sums ← products of the column k + 1 of what comes out with all.
template <std::size_t lanes, int k>
JOINTID_INLINE void update_panel(double* x, std::size_t rows, const double (&w)[panel], double (&sums)[panel]) {
  Row<lanes> step;
  step.load_from(w);
  const auto one = [&](double* row, Row<lanes>& to) {
    Row<lanes> value;
    value.load_from(row);
    value.add(-row[k], step);
    value.store_to(row);
    to.add(value.template at<k + 1>(), value);
  };
  sum_rows<lanes>(x, rows, one, sums);
}

/// What the reflections of a panel are made of: V has the diagonal `heads` above the panel, `gammas` of each, and above the diagonal
/// of `products` the products of the panel's columns.
struct Reflections {
  double heads[panel], gammas[panel];
  Square products;
};

/// Reflects the columns k and behind it, whose products with column k are `sums`; w = γuᵀ[R; X] of each. Columns before k stay as
/// they are, so that the sums are their products with column k, too.
template <std::size_t lanes, int k>
JOINTID_INLINE void reflect_columns(double* r, std::size_t stride, double* x, std::size_t rows, double (&sums)[panel],
                                    Reflections& out) {
  double* top = r + k * stride;
  const Reflection h = reflection(top[k], sums[k]);
  double w[panel] = {};
  for (std::size_t j = 0; j < k; ++j) out.products[j][k] = sums[j];
  for (std::size_t j = k + 1; j < panel; ++j) {
    w[j] = h.gamma * (h.head * top[j] + sums[j]);
    top[j] -= h.head * w[j];
  }
  top[k] = h.beta;
  out.heads[k] = h.head;
  out.gammas[k] = h.gamma;
  if constexpr (k + 1 < panel) {
    update_panel<lanes, k>(x, rows, w, sums);
    reflect_columns<lanes, k + 1>(r, stride, x, rows, sums, out);
  }
}

/// Reflects the columns of a panel x below the diagonal square r of the triangle one after another: x becomes the lower part of V,
/// whose upper part is the diagonal `heads`; t of I − VTVᵀ, their product.
template <std::size_t lanes>
JOINTID_INLINE void reflect_panel(double* r, std::size_t stride, double* x, std::size_t rows, Reflections& out, Square& t) {
  double sums[panel];
  first_sums<lanes>(x, rows, sums);
  reflect_columns<lanes, 0>(r, stride, x, rows, sums, out);
  for (std::size_t j = 0; j < panel; ++j) {
    for (std::size_t i = 0; i < panel; ++i) {
      double sum = 0.0;
      for (std::size_t k = i; k < j; ++k) sum += t[i][k] * out.products[k][j];
      t[i][j] = i < j ? -out.gammas[j] * sum : i == j ? out.gammas[j] : 0.0;
    }
  }
}

/// Applies (I − VTVᵀ)ᵀ to a square of the triangle and the panel x below it.
template <std::size_t lanes>
JOINTID_INLINE void apply(const double* v, const double (&heads)[panel], const Square& t, double* r, std::size_t stride,
                          double* x, std::size_t rows) {
  Square product, w = {};
  for (std::size_t i = 0; i < panel; ++i) {
    for (std::size_t j = 0; j < panel; ++j) product[i][j] = heads[i] * r[i * stride + j];
  }
  add_product<lanes>(v, x, rows, product);
  for (std::size_t i = 0; i < panel; ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
#pragma omp simd
      for (std::size_t j = 0; j < panel; ++j) w[i][j] += t[k][i] * product[k][j];
    }
    for (std::size_t j = 0; j < panel; ++j) r[i * stride + j] -= heads[i] * w[i][j];
  }
  subtract_product<lanes>(v, x, rows, w);
}

/// R of [R; X], R [width, width], X in panels, which are destroyed.
template <std::size_t lanes>
JOINTID_INLINE void take_in_lanes(double* r, double* x, std::size_t rows, std::size_t width) {
  Square t;
  Reflections made;
  for (std::size_t k = 0; k < width; k += panel) {
    double* v = x + k / panel * panel_size;
    reflect_panel<lanes>(r + k * width + k, width, v, rows, made, t);
    for (std::size_t c = k + panel; c < width; c += panel)
      apply<lanes>(v, made.heads, t, r + k * width + c, width, x + c / panel * panel_size, rows);
  }
}

JOINTID_KERNEL_OF_LANES(void take_in, (double* r, double* x, std::size_t rows, std::size_t width), take_in_lanes,
                        (r, x, rows, width))

/// Reflects the column of ones onto the corner and applies that to the row `top` and the panels.
JOINTID_KERNEL void take_ones_in(double& corner, double* top, const double* ones, double* x, std::size_t rows,
                                        std::size_t width) {
  double below = 0.0;
  for (std::size_t i = 0; i < rows; ++i) below += ones[i] * ones[i];
  const Reflection h = reflection(corner, below);
  corner = h.beta;
  for (std::size_t k = 0; k < width; k += panel) {
    double sums[panel] = {}, w[panel];
    double* block = x + k / panel * panel_size;
    for (std::size_t i = 0; i < rows; ++i) {
#pragma omp simd
      for (std::size_t j = 0; j < panel; ++j) sums[j] += ones[i] * block[i * panel + j];
    }
    for (std::size_t j = 0; j < panel; ++j) {
      w[j] = h.gamma * (h.head * top[k + j] + sums[j]);
      top[k + j] -= h.head * w[j];
    }
    for (std::size_t i = 0; i < rows; ++i) {
      const double v = ones[i];
#pragma omp simd
      for (std::size_t j = 0; j < panel; ++j) block[i * panel + j] -= v * w[j];
    }
  }
}

/// Copies a row into its places in the panels and says whether its numbers are finite: products with 0 are 0, or not a number.
JOINTID_KERNEL bool copy_finite(const double* row, std::size_t columns, double* to) {
  double sums[panel] = {};
  const auto number = [&](std::size_t k, std::size_t j) {
    const double value = row[k + j];
    to[k / panel * panel_size + j] = value;
    sums[j] += value * 0.0;
  };
  std::size_t k = 0;
  for (; k + panel <= columns; k += panel) {
#pragma omp simd
    for (std::size_t j = 0; j < panel; ++j) number(k, j);
  }
  for (std::size_t j = 0; k + j < columns; ++j) number(k, j);
  double sum = 0.0;
  for (const double each : sums) sum += each;
  return sum == 0.0;
}

}  // namespace

TallTriangle::TallTriangle(std::size_t columns)
    : columns_(columns),
      width_((columns + panel - 1) / panel * panel),
      top_(width_, 0.0),
      triangle_(width_ * width_, 0.0),
      ones_(most_rows, 0.0),
      panels_(width_ / panel * panel_size, 0.0) {}

bool TallTriangle::push(double one, const double* row) {
  if (count_ == most_rows) flush();
  if (!copy_finite(row, columns_, panels_.data() + count_ * panel)) return false;
  ones_[count_] = one;
  ++count_;
  return true;
}

void TallTriangle::flush() {
  if (count_ == 0) return;
  take_ones_in(corner_, top_.data(), ones_.data(), panels_.data(), count_, width_);
  take_in(triangle_.data(), panels_.data(), count_, width_);
  if (width_ > columns_) std::fill(panels_.begin(), panels_.end(), 0.0);  // columns that pad the last panel stay zero
  count_ = 0;
}

}  // namespace jointid::oscillation

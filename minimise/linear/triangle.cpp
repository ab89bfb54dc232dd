#include "minimise/linear/triangle.hpp"

#include <algorithm>
#include <cmath>

#include "base/kernel.hpp"

namespace jointid::minimise {
namespace {

/// Columns are handled `wide` or `narrow` at a time, so that their sums stay in registers.
constexpr std::size_t wide = 24, narrow = 8;

/// Applies I − τvvᵀ, v = (1, x), to `panel` columns of the row `top` and the block below it. `chains` rows are summed side
/// by side, so that one addition need not wait for the last.
template <std::size_t panel, std::size_t chains>
JOINTID_INLINE void reflect_panel(double* top, double* block, std::size_t rows, std::size_t stride, const double* x, double tau) {
  double sums[chains][panel] = {};
  std::size_t i = 0;
  for (; i + chains <= rows; i += chains) {
    for (std::size_t c = 0; c < chains; ++c) {
      const double* row = block + (i + c) * stride;
#pragma omp simd
      for (std::size_t j = 0; j < panel; ++j) sums[c][j] += x[i + c] * row[j];
    }
  }
  for (; i < rows; ++i) {
    const double* row = block + i * stride;
#pragma omp simd
    for (std::size_t j = 0; j < panel; ++j) sums[0][j] += x[i] * row[j];
  }
  double sum[panel];
  for (std::size_t j = 0; j < panel; ++j) {
    sum[j] = top[j];
    for (std::size_t c = 0; c < chains; ++c) sum[j] += sums[c][j];
    sum[j] *= tau;
    top[j] -= sum[j];
  }
#pragma GCC unroll 4
  for (i = 0; i < rows; ++i) {
    double* row = block + i * stride;
#pragma omp simd
    for (std::size_t j = 0; j < panel; ++j) row[j] -= x[i] * sum[j];
  }
}

/// Householder QR of [R; X]: R upper triangular [width × stride], X [rows × stride] is destroyed.
JOINTID_KERNEL void reduce(double* r, double* x, std::size_t rows, std::size_t width, std::size_t stride, double* v) {
  for (std::size_t k = 0; k < width; ++k) {
    double below = 0.0;
#pragma GCC unroll 8
    for (std::size_t i = 0; i < rows; ++i) v[i] = x[i * stride + k];
#pragma omp simd reduction(+ : below)
    for (std::size_t i = 0; i < rows; ++i) below += v[i] * v[i];
    if (below == 0.0) continue;
    const double alpha = r[k * stride + k];
    const double norm = std::sqrt(alpha * alpha + below);
    const double beta = alpha > 0.0 ? -norm : norm;
    const double pivot = alpha - beta;
    const double tau = -pivot / beta;
    const double scale = 1.0 / pivot;
    for (std::size_t i = 0; i < rows; ++i) v[i] *= scale;
    std::size_t j = k / narrow * narrow;
    for (; j + wide <= stride; j += wide) reflect_panel<wide, 2>(r + k * stride + j, x + j, rows, stride, v, tau);
    for (; j < stride; j += narrow) reflect_panel<narrow, 4>(r + k * stride + j, x + j, rows, stride, v, tau);
    r[k * stride + k] = beta;
  }
  // The first panel of a step also holds columns that are done: what it leaves there, below the diagonal of R and in X, is
  // rounding noise that nobody reads.
  std::fill(x, x + rows * stride, 0.0);
}

/// Adds XᵀX to the upper triangle g; X is cleared.
JOINTID_KERNEL void add_product(double* g, double* x, std::size_t rows, std::size_t width, std::size_t stride) {
  for (std::size_t i = 0; i < rows; ++i) {
    double* row = x + i * stride;
    for (std::size_t k = 0; k < width; ++k) {
      double* to = g + k * stride;
#pragma omp simd
      for (std::size_t j = k; j < width; ++j) to[j] += row[k] * row[j];
    }
    std::fill(row, row + stride, 0.0);
  }
}

}  // namespace

Triangle::Triangle(std::size_t unknowns, Reduction reduction)
    : reduction_(reduction),
      unknowns_(unknowns),
      width_(unknowns + 1),
      stride_((width_ + narrow - 1) / narrow * narrow),
      capacity_(std::max<std::size_t>(128, 2 * width_)),
      triangle_(width_ * stride_, 0.0),
      buffer_(capacity_ * stride_, 0.0),
      scratch_(capacity_) {}

double* Triangle::append(std::size_t count) {
  if (buffered_ + count > capacity_) flush();
  if (count > capacity_) {
    capacity_ = count;
    buffer_.assign(capacity_ * stride_, 0.0);
    scratch_.resize(capacity_);
  }
  double* rows = buffer_.data() + buffered_ * stride_;
  buffered_ += count;
  rows_pushed_ += count;
  return rows;
}

void Triangle::flush() {
  if (reduction_ == Reduction::normal) {
    add_product(triangle_.data(), buffer_.data(), buffered_, width_, stride_);
  } else {
    reduce(triangle_.data(), buffer_.data(), buffered_, width_, stride_, scratch_.data());
  }
  buffered_ = 0;
}

void Triangle::release() {
  buffer_ = {};
  scratch_ = {};
  capacity_ = 0;
}

void Triangle::merge(Triangle& other) {
  other.flush();
  const std::size_t pushed = rows_pushed_ + other.rows_pushed_;
  if (reduction_ == Reduction::normal) {
    for (std::size_t i = 0; i < triangle_.size(); ++i) triangle_[i] += other.triangle_[i];
    rows_pushed_ = pushed;
    return;
  }
  double* rows = append(width_);
  for (std::size_t i = 0; i < width_; ++i) {
    const std::size_t at = i * stride_ + i;
    std::copy_n(other.triangle_.data() + at, width_ - i, rows + at);
  }
  rows_pushed_ = pushed;
}

void Triangle::pack(std::vector<double>& out) const {
  out.push_back(static_cast<double>(rows_pushed_));
  for (std::size_t i = 0; i < width_; ++i) out.insert(out.end(), &triangle_[i * stride_ + i], &triangle_[i * stride_] + width_);
}

Triangle Triangle::unpacked(std::size_t unknowns, Reduction reduction, std::span<const double> packed) {
  Triangle out(unknowns, reduction);
  out.rows_pushed_ = static_cast<std::size_t>(packed.front());
  auto from = packed.begin() + 1;
  for (std::size_t i = 0; i < out.width_; ++i) {
    const auto count = static_cast<std::ptrdiff_t>(out.width_ - i);
    std::copy_n(from, count, &out.triangle_[i * out.stride_ + i]);
    from += count;
  }
  return out;
}

}  // namespace jointid::minimise

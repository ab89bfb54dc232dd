#include "minimise/linear/complex_triangle.hpp"

#include <algorithm>
#include <cmath>

#include "base/kernel.hpp"

namespace jointid::minimise {
namespace {

constexpr std::size_t panel = 8;

/// Applies I − τvvᴴ, v = (1, x), to a panel of the row `top` and of the block below it. Imaginary parts lie `half` further.
JOINTID_INLINE void reflect_panel(double* top, double* block, std::size_t rows, std::size_t half, const double* x_re,
                                  const double* x_im, double tau) {
  double re[2][panel] = {}, im[2][panel] = {};  // two rows side by side: one addition need not wait for the last
  const std::size_t stride = 2 * half;
  const auto add = [&](std::size_t chain, std::size_t i) {
    const double a = x_re[i], b = x_im[i];
    const double* row = block + i * stride;
#pragma omp simd
    for (std::size_t j = 0; j < panel; ++j) {
      re[chain][j] += a * row[j] + b * row[half + j];
      im[chain][j] += a * row[half + j] - b * row[j];
    }
  };
  std::size_t i = 0;
  for (; i + 2 <= rows; i += 2) {
    add(0, i);
    add(1, i + 1);
  }
  if (i < rows) add(0, i);
  double sum_re[panel], sum_im[panel];
  for (std::size_t j = 0; j < panel; ++j) {
    sum_re[j] = tau * (top[j] + re[0][j] + re[1][j]);
    sum_im[j] = tau * (top[half + j] + im[0][j] + im[1][j]);
    top[j] -= sum_re[j];
    top[half + j] -= sum_im[j];
  }
  for (i = 0; i < rows; ++i) {
    const double a = x_re[i], b = x_im[i];
    double* row = block + i * stride;
#pragma omp simd
    for (std::size_t j = 0; j < panel; ++j) {
      row[j] -= a * sum_re[j] - b * sum_im[j];
      row[half + j] -= a * sum_im[j] + b * sum_re[j];
    }
  }
}

/// Householder QR of [R; X], R upper triangular; X is cleared. Left of the diagonal R holds rounding noise afterwards.
JOINTID_KERNEL void reduce(double* r, double* x, std::size_t rows, std::size_t width, std::size_t half, double* v) {
  const std::size_t stride = 2 * half;
  double* v_re = v;
  double* v_im = v + rows;
  for (std::size_t k = 0; k < width; ++k) {
    double below = 0.0;
    for (std::size_t i = 0; i < rows; ++i) {
      v_re[i] = x[i * stride + k];
      v_im[i] = x[i * stride + half + k];
    }
#pragma omp simd reduction(+ : below)
    for (std::size_t i = 0; i < 2 * rows; ++i) below += v[i] * v[i];
    if (below == 0.0) continue;
    double* top = r + k * stride;
    const double head2 = top[k] * top[k] + top[half + k] * top[half + k];
    const double norm = std::sqrt(head2 + below), head = std::sqrt(head2);
    const double phase_re = head > 0.0 ? top[k] / head : 1.0, phase_im = head > 0.0 ? top[half + k] / head : 0.0;
    // v = (α − β, x) with β = −e^{i·arg α}·norm, scaled to a leading 1: |α − β| = head + norm.
    const double scale_re = phase_re / (head + norm), scale_im = -phase_im / (head + norm);
    for (std::size_t i = 0; i < rows; ++i) {
      const double a = v_re[i], b = v_im[i];
      v_re[i] = a * scale_re - b * scale_im;
      v_im[i] = a * scale_im + b * scale_re;
    }
    const double tau = (head + norm) / norm;
    for (std::size_t j = k / panel * panel; j < half; j += panel) reflect_panel(top + j, x + j, rows, half, v_re, v_im, tau);
    top[k] = -phase_re * norm;
    top[half + k] = -phase_im * norm;
  }
  std::fill(x, x + rows * stride, 0.0);
}

}  // namespace

std::size_t ComplexTriangle::half(std::size_t unknowns) { return (unknowns + panel) / panel * panel; }

ComplexTriangle::ComplexTriangle(std::size_t unknowns)
    : unknowns_(unknowns),
      half_(half(unknowns)),
      capacity_(std::max<std::size_t>(64, 2 * (unknowns + 1))),
      triangle_((unknowns + 1) * 2 * half_, 0.0),
      buffer_(capacity_ * 2 * half_, 0.0),
      scratch_(2 * capacity_) {}

double* ComplexTriangle::append(std::size_t count) {
  if (buffered_ + count > capacity_) flush();
  if (count > capacity_) {
    capacity_ = count;
    buffer_.assign(capacity_ * stride(), 0.0);
    scratch_.resize(2 * capacity_);
  }
  double* rows = buffer_.data() + buffered_ * stride();
  buffered_ += count;
  pushed_ += count;
  return rows;
}

void ComplexTriangle::flush() {
  reduce(triangle_.data(), buffer_.data(), buffered_, unknowns_ + 1, half_, scratch_.data());
  buffered_ = 0;
}

void ComplexTriangle::pour(std::span<const std::size_t> real_columns, std::span<const std::size_t> imaginary_columns,
                           Triangle& to) {
  if (pushed_ == 0) return;
  flush();
  for (std::size_t i = 0; i <= unknowns_; ++i) {
    const double* re = triangle_.data() + i * stride();
    const double* im = re + half_;
    double* real_row = to.append(2);
    double* imaginary_row = real_row + to.stride();
    for (std::size_t j = i; j < unknowns_; ++j) {
      real_row[real_columns[j]] = re[j];
      real_row[imaginary_columns[j]] = -im[j];
      imaginary_row[real_columns[j]] = im[j];
      imaginary_row[imaginary_columns[j]] = re[j];
    }
    real_row[to.unknowns()] = re[unknowns_];
    imaginary_row[to.unknowns()] = im[unknowns_];
  }
  std::fill(triangle_.begin(), triangle_.end(), 0.0);
  pushed_ = 0;
}

}  // namespace jointid::minimise

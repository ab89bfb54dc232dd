#include "ident/equations/kronecker.hpp"

#include <algorithm>
#include <cmath>

#include "base/kernel.hpp"
#include "minimise/linear/split_column.hpp"
#include "minimise/linear/thin_qr.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t width = 8;  ///< columns of C handled at a time
constexpr std::size_t depth = 4;  ///< columns of Q_A handled at a time

/// d(n, 0…width) = Σ_m conj(q(m,n)) c(m, 0…width) for n in [first, first + count), count ≤ depth.
template <std::size_t count>
JOINTID_INLINE void project(const double* q_re, const double* q_im, std::size_t m, const double* c_re,
                            const double* c_im, double* d_re, double* d_im, std::size_t stride) {
  double re[count][width] = {}, im[count][width] = {};
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t n = 0; n < count; ++n) {
      const double a = q_re[n * m + i], b = q_im[n * m + i];
#pragma omp simd
      for (std::size_t l = 0; l < width; ++l) {
        re[n][l] += a * c_re[i * width + l] + b * c_im[i * width + l];
        im[n][l] += a * c_im[i * width + l] - b * c_re[i * width + l];
      }
    }
  }
  for (std::size_t n = 0; n < count; ++n) {
    std::copy(re[n], re[n] + width, d_re + n * stride);
    std::copy(im[n], im[n] + width, d_im + n * stride);
  }
}

/// Q_Aᴴ W_r (C₁ − C₂) for the chosen rows and columns: d [steps × stride], stride a multiple of `width`.
JOINTID_KERNEL void project_right_side(const double* c1, std::size_t stride1, const double* c2, std::size_t stride2,
                                       const std::size_t* rows, std::size_t m, const std::size_t* columns,
                                       std::size_t l_count, const double* q_re, const double* q_im, std::size_t steps,
                                       double* d_re, double* d_im, std::size_t stride, double* panel_re,
                                       double* panel_im) {
  for (std::size_t l0 = 0; l0 < l_count; l0 += width) {
    const std::size_t used = std::min(width, l_count - l0);
    for (std::size_t i = 0; i < m; ++i) {
      const double* row1 = c1 + 2 * rows[i] * stride1;
      const double* row2 = c2 + 2 * rows[i] * stride2;
      for (std::size_t l = 0; l < used; ++l) {
        const std::size_t at = 2 * columns[l0 + l];
        panel_re[i * width + l] = row1[at] - row2[at];
        panel_im[i * width + l] = row1[at + 1] - row2[at + 1];
      }
    }
    std::size_t n = 0;
    for (; n + depth <= steps; n += depth) {
      project<depth>(q_re + n * m, q_im + n * m, m, panel_re, panel_im, d_re + n * stride + l0, d_im + n * stride + l0,
                     stride);
    }
    for (; n < steps; ++n) {
      project<1>(q_re + n * m, q_im + n * m, m, panel_re, panel_im, d_re + n * stride + l0, d_im + n * stride + l0,
                 stride);
    }
  }
}

/// c(p,q) = Σ_l d(p,l) conj(q_b(l,q)).
JOINTID_KERNEL void project_left(const double* d_re, const double* d_im, std::size_t p_count, std::size_t stride,
                                 const double* q_re, const double* q_im, std::size_t l_count, std::size_t q_count,
                                 double* c_re, double* c_im) {
  for (std::size_t p = 0; p < p_count; ++p) {
    const minimise::Column d{const_cast<double*>(d_re) + p * stride, const_cast<double*>(d_im) + p * stride};
    for (std::size_t q = 0; q < q_count; ++q) {
      const minimise::Column b{const_cast<double*>(q_re) + q * l_count, const_cast<double*>(q_im) + q * l_count};
      dot(b, d, l_count, c_re[p * q_count + q], c_im[p * q_count + q]);
    }
  }
}

/// Whether all elements of a block are finite, its rows `stride` numbers apart.
JOINTID_KERNEL bool finite(const double* block, std::size_t rows, std::size_t columns, std::size_t stride) {
  double sum = 0.0;  // stays 0 unless some x·0 is NaN
  for (std::size_t i = 0; i < rows; ++i) {
    const double* row = block + i * stride;
#pragma omp simd reduction(+ : sum)
    for (std::size_t j = 0; j < columns; ++j) sum += row[j] * 0.0;
  }
  return sum == 0.0;
}

bool finite(const minimise::View& view) {
  return finite(reinterpret_cast<const double*>(view.data), view.rows, 2 * view.columns, 2 * view.stride);
}

void scale_columns(std::vector<double>& re, std::vector<double>& im, std::size_t rows, std::size_t columns,
                   std::span<const double> weight) {
  for (std::size_t k = 0; k < columns; ++k) {
    for (std::size_t i = 0; i < rows; ++i) {
      re[k * rows + i] *= weight[i];
      im[k * rows + i] *= weight[i];
    }
  }
}

/// Element (i,k) of a rows × columns matrix to two arrays, columns contiguous.
template <class Element>
void load(std::vector<double>& re, std::vector<double>& im, std::size_t rows, std::size_t columns,
          const Element& element) {
  re.resize(rows * columns);
  im.resize(rows * columns);
  for (std::size_t k = 0; k < columns; ++k) {
    for (std::size_t i = 0; i < rows; ++i) {
      const Complex value = element(i, k);
      re[k * rows + i] = value.real();
      im[k * rows + i] = value.imag();
    }
  }
}

Complex weighted_a(const minimise::LineProduct& line, const SubProduct& part, std::size_t i, std::size_t k) {
  if (line.a_is_unit) return part.rows[i] == part.a_dofs[k] ? part.row_weight[i] : 0.0;
  return line.a(part.rows[i], part.a_dofs[k]) * part.row_weight[i];
}

Complex weighted_b(const minimise::LineProduct& line, const SubProduct& part, std::size_t i, std::size_t k) {
  return line.b(part.b_dofs[k], part.columns[i]) * part.column_weight[i];
}

/// The upper triangle of x (columns contiguous) as the row-major P×N matrix R.
void copy_triangle(const std::vector<double>& re, const std::vector<double>& im, std::size_t m, std::size_t n,
                   SplitMatrix& r) {
  r.resize(std::min(m, n), n);
  for (std::size_t p = 0; p < r.rows; ++p) {
    for (std::size_t i = 0; i < n; ++i) {
      r.re[p * n + i] = i < p ? 0.0 : re[i * m + p];
      r.im[p * n + i] = i < p ? 0.0 : im[i * m + p];
    }
  }
}

}  // namespace

bool right_side_is_finite(const minimise::LineProduct& line) { return finite(line.c1) && finite(line.c2); }

void SplitMatrix::resize(std::size_t r, std::size_t c) {
  rows = r;
  columns = c;
  re.resize(r * c);
  im.resize(r * c);
}

/// Thin QR of the m×n matrix of `element`, m weights that are in it already.
template <class Element>
void KroneckerCompressor::factor(const Element& element, std::span<const double> weight, std::size_t n, Factor& factor,
                                 SplitMatrix& r) {
  const std::size_t m = weight.size(), steps = std::min(m, n);
  load(factor.re, factor.im, m, n, element);
  factor.q_re.resize(m * steps);
  factor.q_im.resize(m * steps);
  tau_.resize(steps);
  minimise::thin_qr(factor.re.data(), factor.im.data(), m, n, factor.q_re.data(), factor.q_im.data(), tau_.data());
  copy_triangle(factor.re, factor.im, m, n, r);
  // The weights of C go into Q_A and Q_B, so that C itself is read once and never copied.
  scale_columns(factor.q_re, factor.q_im, m, steps, weight);
}

void KroneckerCompressor::compress(const minimise::LineProduct& line, const SubProduct& part, bool same_a, Compressed& out) {
  const auto a = [&](std::size_t i, std::size_t k) { return weighted_a(line, part, i, k); };
  const auto b = [&](std::size_t i, std::size_t k) { return weighted_b(line, part, i, k); };
  if (!same_a) factor(a, part.row_weight, part.a_dofs.size(), a_, out.ra);
  factor(b, part.column_weight, part.b_dofs.size(), b_, out.rb);
  const std::size_t m = part.rows.size(), l = part.columns.size();
  const std::size_t stride = (l + width - 1) / width * width;
  d_re_.resize(out.ra.rows * stride);
  d_im_.resize(out.ra.rows * stride);
  panel_re_.resize(m * width);
  panel_im_.resize(m * width);
  project_right_side(reinterpret_cast<const double*>(line.c1.data), line.c1.stride,
                     reinterpret_cast<const double*>(line.c2.data), line.c2.stride, part.rows.data(), m,
                     part.columns.data(), l, a_.q_re.data(), a_.q_im.data(), out.ra.rows, d_re_.data(), d_im_.data(),
                     stride, panel_re_.data(), panel_im_.data());
  out.c.resize(out.ra.rows, out.rb.rows);
  project_left(d_re_.data(), d_im_.data(), out.ra.rows, stride, b_.q_re.data(), b_.q_im.data(), l, out.rb.rows,
               out.c.re.data(), out.c.im.data());
}

void KroneckerCompressor::copy(const minimise::LineProduct& line, const SubProduct& part, Compressed& out) {
  const auto fill = [](SplitMatrix& to, std::size_t rows, std::size_t columns, const auto& element) {
    to.resize(rows, columns);
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t k = 0; k < columns; ++k) {
        const Complex value = element(i, k);
        to.re[i * columns + k] = value.real();
        to.im[i * columns + k] = value.imag();
      }
    }
  };
  fill(out.ra, part.rows.size(), part.a_dofs.size(),
       [&](std::size_t i, std::size_t k) { return weighted_a(line, part, i, k); });
  fill(out.rb, part.columns.size(), part.b_dofs.size(),
       [&](std::size_t i, std::size_t k) { return weighted_b(line, part, i, k); });
  fill(out.c, part.rows.size(), part.columns.size(), [&](std::size_t i, std::size_t k) {
    return (line.c1(part.rows[i], part.columns[k]) - line.c2(part.rows[i], part.columns[k])) *
           (part.row_weight[i] * part.column_weight[k]);
  });
}

}  // namespace jointid::ident

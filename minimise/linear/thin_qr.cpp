#include "minimise/linear/thin_qr.hpp"

#include <algorithm>
#include <cmath>

#include "base/kernel.hpp"
#include "minimise/linear/split_column.hpp"

namespace jointid::minimise {
namespace {

/// Columns of a matrix from a given row on.
struct Columns {
  double* re;
  double* im;
  std::size_t m;

  JOINTID_INLINE Column operator()(std::size_t k, std::size_t from) const { return {re + k * m + from, im + k * m + from}; }
};

JOINTID_INLINE void reflect(const Column& v, double tau, std::size_t count, const Column& x) {
  double re, im;
  dot(v, x, count, re, im);
  subtract(v, tau * re, tau * im, count, x);
}

/// Turns column k of x into βe₁ and the columns right of it accordingly; v goes to column k of q. Returns τ.
JOINTID_INLINE double eliminate(const Columns& column, const Columns& q, std::size_t k, std::size_t n) {
  const std::size_t count = column.m - k;
  const Column x = column(k, k), v = q(k, k);
  double norm2, unused;
  dot(x, x, count, norm2, unused);
  if (norm2 == 0.0) {
    std::fill(v.re, v.re + count, 0.0);
    std::fill(v.im, v.im + count, 0.0);
    return 0.0;
  }
  // β = −e^{i·arg x₀}‖x‖; v = x − βe₁, whose first element has modulus |x₀| + ‖x‖: no cancellation.
  const double norm = std::sqrt(norm2);
  const double head = std::sqrt(x.re[0] * x.re[0] + x.im[0] * x.im[0]);
  const double phase_re = head > 0.0 ? x.re[0] / head : 1.0;
  const double phase_im = head > 0.0 ? x.im[0] / head : 0.0;
  x.re[0] += phase_re * norm;
  x.im[0] += phase_im * norm;
  const double tau = 1.0 / (norm * (norm + head));
  for (std::size_t j = k + 1; j < n; ++j) reflect(x, tau, count, column(j, k));
  std::copy(x.re, x.re + count, v.re);
  std::copy(x.im, x.im + count, v.im);
  std::fill(x.re, x.re + count, 0.0);
  std::fill(x.im, x.im + count, 0.0);
  x.re[0] = -phase_re * norm;
  x.im[0] = -phase_im * norm;
  return tau;
}

/// Replaces v in column k of q by column k of Q; the columns right of it hold Q's already.
JOINTID_INLINE void form_column(const Columns& q, std::size_t k, std::size_t steps, double tau) {
  const std::size_t count = q.m - k;
  const Column v = q(k, k), whole = q(k, 0);
  for (std::size_t j = k + 1; j < steps; ++j) reflect(v, tau, count, q(j, k));
  const double head_re = tau * v.re[0], head_im = -tau * v.im[0];
  for (std::size_t i = 0; i < count; ++i) {
    const double re = v.re[i], im = v.im[i];
    v.re[i] = -(re * head_re - im * head_im);
    v.im[i] = -(re * head_im + im * head_re);
  }
  v.re[0] += 1.0;
  std::fill(whole.re, whole.re + k, 0.0);
  std::fill(whole.im, whole.im + k, 0.0);
}

}  // namespace

JOINTID_KERNEL void thin_qr(double* x_re, double* x_im, std::size_t m, std::size_t n, double* q_re, double* q_im, double* tau) {
  const Columns x{x_re, x_im, m}, q{q_re, q_im, m};
  const std::size_t steps = std::min(m, n);
  for (std::size_t k = 0; k < steps; ++k) tau[k] = eliminate(x, q, k, n);
  for (std::size_t k = steps; k-- > 0;) form_column(q, k, steps, tau[k]);
}

}  // namespace jointid::minimise

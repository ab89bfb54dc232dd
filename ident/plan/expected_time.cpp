#include "ident/plan/expected_time.hpp"

#include <algorithm>

#include "base/eigen.hpp"
#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "dense/blas.hpp"
#include "dense/cholesky.hpp"

namespace jointid::ident {
namespace {

constexpr double kernel_seconds = 0.1;

/// Of one iteration of one line besides its matrices.
constexpr double bookkeeping_seconds = 3e-5;

/// A well-conditioned matrix: n on the diagonal, 1 elsewhere.
template <class Matrix>
Matrix definite(Eigen::Index n) {
  Matrix a = Matrix::Ones(n, n);
  a.diagonal().setConstant(static_cast<double>(n));
  return a;
}

/// Flop/s of Cholesky factors of this size; `flops`: of one.
template <class Matrix>
double rate(Eigen::Index n, double flops) {
  const Matrix a = definite<Matrix>(n);
  Matrix factor = a;
  dense::cholesky_in_place(factor);  // what is loaded on first use
  const Clock::time_point start = Clock::now();
  std::size_t times = 0;
  while (seconds_since(start) < kernel_seconds) {
    factor = a;
    dense::cholesky_in_place(factor);
    ++times;
  }
  return static_cast<double>(times) * flops / seconds_since(start);
}

}  // namespace

double expected_seconds(const Cost& cost, std::size_t threads) {
  const Iteration& iteration = cost.iteration;
  if (iteration.expected == 0) return 0.0;
  const auto n = at(iteration.matrix);
  const double cube = static_cast<double>(n) * static_cast<double>(n) * static_cast<double>(n);
  const double speed = iteration.complex ? rate<Eigen::MatrixXcd>(n, 4.0 / 3.0 * cube) : rate<Eigen::MatrixXd>(n, cube / 3.0);
  const std::size_t used = std::min({threads_or_cores(threads), threads_or_cores(0), std::max<std::size_t>(1, cost.lines)});
  const double each = iteration.flops / speed + static_cast<double>(cost.lines) * bookkeeping_seconds;
  return static_cast<double>(iteration.expected) * each / static_cast<double>(used);
}

bool are_expected_within(double seconds, const Cost& cost) {
  constexpr double slow = 5e8;  // flop/s
  const double each = cost.iteration.flops / slow + static_cast<double>(cost.lines) * bookkeeping_seconds;
  return static_cast<double>(cost.iteration.expected) * each < seconds || expected_seconds(cost) < seconds;
}

}  // namespace jointid::ident

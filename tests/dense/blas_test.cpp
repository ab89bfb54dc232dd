#include "dense/blas.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <atomic>
#include <random>
#include <thread>
#include <vector>

namespace jointid::dense {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;

MatrixXcd any(Index rows, Index columns, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return MatrixXcd::NullaryExpr(rows, columns, [&] { return std::complex(normal(random), normal(random)); });
}

/// Σ over the inner index, entry by entry.
MatrixXcd product(const MatrixXcd& a, const MatrixXcd& b) {
  MatrixXcd out = MatrixXcd::Zero(a.rows(), b.rows());
  for (Index i = 0; i < a.rows(); ++i) {
    for (Index j = 0; j < b.rows(); ++j) {
      for (Index k = 0; k < a.cols(); ++k) out(i, j) += a(i, k) * std::conj(b(j, k));
    }
  }
  return out;
}

double off(const MatrixXcd& a, const MatrixXcd& b) { return (a - b).norm() / (1.0 + b.norm()); }

MatrixXcd lower(const MatrixXcd& a) { return a.triangularView<Eigen::Lower>(); }

/// What all functions are off their definitions, for an n×n matrix; blocks of a larger one, so that columns do not touch.
double errors(Index n, Index depth, std::mt19937_64& random) {
  MatrixXcd store = MatrixXcd::Zero(n + 3, n + 2);
  const MatrixXcd a = any(n, depth, random), b = any(n, depth, random);
  store.topLeftCorner(n, n) = MatrixXcd::Identity(n, n);
  add_square(a, store.topLeftCorner(n, n));
  const MatrixXcd square = MatrixXcd::Identity(n, n) + product(a, a);
  double worst = off(lower(store.topLeftCorner(n, n)), lower(square));
  MatrixXcd c = square;
  add_product(a, b, c);
  worst = std::max(worst, off(c - square, product(a, b)));
  MatrixXcd rest = square;
  subtract_square(a, rest);
  worst = std::max(worst, off(lower(rest), MatrixXcd::Identity(n, n)));
  MatrixXcd of_depth = square.topLeftCorner(1, 1).replicate(depth, depth);
  const MatrixXcd before = of_depth;
  subtract_adjoint_product(a, b, of_depth);
  worst = std::max(worst, off(before - of_depth, product(a.adjoint(), b.adjoint())));
  if (!cholesky_in_place(store.topLeftCorner(n, n))) return 1.0;
  const MatrixXcd l = lower(store.topLeftCorner(n, n));
  worst = std::max(worst, off(product(l, l), square));
  MatrixXcd x = l * b;
  solve_lower(l, x);
  worst = std::max(worst, off(x, b));
  x = l.adjoint() * b;
  solve_lower_adjoint(l, x);
  return std::max(worst, off(x, b));
}

/// Small ones are Eigen's, larger ones those of the module where it is there.
RC_GTEST_PROP(Blas, IsWhatItSays, (unsigned seed)) {
  std::mt19937_64 random(seed);
  RC_ASSERT(errors(*rc::gen::inRange<Index>(1, 90), *rc::gen::inRange<Index>(1, 90), random) < 1e-10);
}

TEST(Blas, ProductsOfNoDepthAddNothing) {
  for (const Index n : {1, 3, 60}) {
    const MatrixXcd none(n, 0), before = MatrixXcd::Identity(n, n);
    MatrixXcd c = before;
    add_square(none, c);
    subtract_square(none, c);
    add_product(none, none, c);
    subtract_adjoint_product(none.transpose(), none.transpose(), c);
    EXPECT_EQ(c, before) << n;
  }
}

TEST(Blas, TellsThatAMatrixIsNotPositiveDefinite) {
  for (const Index n : {3, 60}) {
    MatrixXcd a = MatrixXcd::Identity(n, n);
    a(n - 1, n - 1) = -1.0;
    EXPECT_FALSE(cholesky_in_place(a));
  }
}

/// A build of OpenBLAS without locks has thousands of these wrong.
TEST(Blas, IsTheSameForThreadsAtOnce) {
  std::atomic<int> wrong = 0;
  std::vector<std::jthread> threads;
  for (unsigned t = 0; t < 4; ++t) {
    threads.emplace_back([&wrong, t] {
      std::mt19937_64 random(t);
      const MatrixXcd a = any(64, 70, random);
      MatrixXcd first = MatrixXcd::Identity(64, 64);
      add_square(a, first);
      MatrixXcd factor = first;
      cholesky_in_place(factor);
      for (int k = 0; k < 10000; ++k) {
        MatrixXcd again = MatrixXcd::Identity(64, 64);
        add_square(a, again);
        if (again != first) ++wrong;
        cholesky_in_place(again);
        if (again != factor) ++wrong;
      }
    });
  }
  threads.clear();
  EXPECT_EQ(wrong, 0);
}

/// A build that found OpenBLAS uses it.
TEST(Blas, ModuleIsThereWhereItWasBuilt) { EXPECT_EQ(has_blas(), JOINTID_HAS_BLAS == 1); }

}  // namespace
}  // namespace jointid::dense

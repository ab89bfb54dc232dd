#include "dense/ridge.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>

#include "dense/svd.hpp"

namespace jointid::dense {
namespace {

using Eigen::MatrixXd;

MatrixXd random(Eigen::Index rows, Eigen::Index columns, unsigned seed, double scale = 1.0) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  return MatrixXd::NullaryExpr(rows, columns, [&] { return scale * normal(generator); });
}

/// By another way: the singular values of B, U = −V·σ/(1 + σ²)·WᵀR.
MatrixXd by_svd(const MatrixXd& b, const MatrixXd& r) {
  const RealSvd svd = jacobi_svd(b, Vectors::thin, Vectors::thin);
  const Eigen::VectorXd factor = svd.sigma.array() / (1.0 + svd.sigma.array().square());
  return -svd.v * factor.asDiagonal() * svd.u.transpose() * r;
}

/// Tall, wide, square, one row, one column, of any size of the numbers: [B; I] has a condition of 1 + ‖B‖.
RC_GTEST_PROP(Ridge, BestIsThatOfSingularValues, ()) {
  const auto rows = *rc::gen::inRange<Eigen::Index>(1, 40), columns = *rc::gen::inRange<Eigen::Index>(1, 40);
  const double scale = std::pow(10.0, *rc::gen::inRange(-6, 7));
  const MatrixXd b = random(rows, columns, *rc::gen::arbitrary<unsigned>(), scale),
                 r = random(rows, 3, *rc::gen::arbitrary<unsigned>());
  const Ridge ridge(b);
  const MatrixXd expected = by_svd(b, r), found = ridge.best(r);
  RC_ASSERT((found - expected).norm() <= 1e-11 * std::max(expected.norm(), 1e-6 * r.norm() / std::max(1.0, scale)));
}

/// `left` has the inner products of [R + BU; U], and no more rows than it needs.
RC_GTEST_PROP(Ridge, LeftIsWhatTheBestLeaves, ()) {
  const auto rows = *rc::gen::inRange<Eigen::Index>(1, 30), columns = *rc::gen::inRange<Eigen::Index>(1, 30);
  const MatrixXd b = random(rows, columns, *rc::gen::arbitrary<unsigned>()), r = random(rows, 4, *rc::gen::arbitrary<unsigned>());
  const Ridge ridge(b);
  const MatrixXd u = by_svd(b, r), left = ridge.left(r);
  const MatrixXd rest = r + b * u;
  const MatrixXd expected = rest.transpose() * rest + u.transpose() * u;
  RC_ASSERT(left.rows() <= std::max<Eigen::Index>(r.cols(), rows + columns > r.cols() ? r.cols() : rows + columns));
  RC_ASSERT((left.transpose() * left - expected).norm() <= 1e-12 * r.squaredNorm());
}

/// Columns of one to three neighbouring rows among full ones, in any order: some stand in blocks of a few rows, some chain them
/// up.
MatrixXd with_narrow_columns(Eigen::Index rows, Eigen::Index narrow, Eigen::Index full, unsigned seed, double scale) {
  MatrixXd b = random(rows, narrow + full, seed, scale);
  std::mt19937_64 generator(seed);
  for (Eigen::Index c = 0; c < b.cols(); ++c) {
    if (static_cast<Eigen::Index>(generator() % static_cast<unsigned>(narrow + full)) < full) continue;
    const Eigen::Index first = static_cast<Eigen::Index>(generator() % static_cast<unsigned>(rows)),
                       count = std::min<Eigen::Index>(rows - first, static_cast<Eigen::Index>(generator() % 4));
    const Eigen::VectorXd kept = b.col(c).segment(first, count);
    b.col(c).setZero();
    b.col(c).segment(first, count) = kept;
  }
  return b;
}

/// U is not refined over all columns at once: to 1e-8 of it where B is 1000.
RC_GTEST_PROP(Ridge, OfNarrowColumnsIsTheSame, ()) {
  const auto rows = *rc::gen::inRange<Eigen::Index>(1, 120), narrow = *rc::gen::inRange<Eigen::Index>(1, 150),
             full = *rc::gen::inRange<Eigen::Index>(0, 20);
  const double scale = std::pow(10.0, *rc::gen::inRange(-4, 4));
  const MatrixXd b = with_narrow_columns(rows, narrow, full, *rc::gen::arbitrary<unsigned>(), scale),
                 r = random(rows, 3, *rc::gen::arbitrary<unsigned>());
  const Ridge ridge(b);
  RC_ASSERT(ridge.b() == b);
  const MatrixXd expected = by_svd(b, r), found = ridge.best(r), left = ridge.left(r), rest = r + b * expected;
  RC_ASSERT((found - expected).norm() <= 1e-8 * std::max(expected.norm(), 1e-6 * r.norm() / std::max(1.0, scale)));
  const MatrixXd products = rest.transpose() * rest + expected.transpose() * expected;
  RC_ASSERT((left.transpose() * left - products).norm() <= 1e-11 * r.squaredNorm());
}

TEST(Ridge, OfNoUnknownsLeavesAll) {
  const MatrixXd r = random(5, 2, 3);
  const Ridge ridge{MatrixXd(5, 0)};
  EXPECT_EQ(ridge.best(r).rows(), 0);
  EXPECT_LT((ridge.left(r).transpose() * ridge.left(r) - r.transpose() * r).norm(), 1e-13);
}

}  // namespace
}  // namespace jointid::dense

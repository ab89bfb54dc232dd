#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "base/eigen.hpp"
#include "dense/cholesky.hpp"
#include "ident/likelihood/line/frf_weight.hpp"
#include "ident/likelihood/line/lane_matrix.hpp"
#include "ident/likelihood/rows/normal_kernels.hpp"
#include "ident/likelihood/rows/normal_rows.hpp"
#include "likelihood_line_sample.hpp"
#include "tests/ident/memory_systems.hpp"
#include "minimise/linear/covariance.hpp"

namespace jointid::ident {
namespace {

using restrictions::Kind;
using restrictions::Pattern;

RC_GTEST_PROP(NormalRows, AddUpToTheProductOfTheDenseMatrix, (unsigned seed)) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const auto up_to = [&](std::size_t most) { return std::uniform_int_distribution<std::size_t>(0, most)(random); };
  std::vector<NormalRows::Run> runs;
  std::size_t tail = 0;
  for (std::size_t r = up_to(5); r > 0; --r) {
    runs.push_back({tail, up_to(12)});
    tail += runs.back().count;
  }
  const std::size_t width = up_to(20), columns = tail + width;
  RC_PRE(columns > 0u);
  NormalRows rows;
  for (int repeat = 0; repeat < 2; ++repeat) {
    const std::size_t count = up_to(8);
    rows.reset(columns, tail);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(at(2 * count), at(columns));
    for (std::size_t row = 0; row < count; ++row) {
      const std::size_t a = up_to(runs.size()), b = up_to(runs.size());
      const auto run = [&](std::size_t i) { return i < runs.size() ? runs[i] : NormalRows::Run{}; };
      const NormalRows::Run first = run(std::min(a, b)), second = a == b ? NormalRows::Run{} : run(std::max(a, b));
      std::size_t place = 0;
      for (const NormalRows::Run& each : {first, second, NormalRows::Run{tail, width}}) {
        for (std::size_t i = 0; i < each.count; ++i, ++place) {
          dense(at(2 * row), at(each.first + i)) = rows.real()[place] = normal(random);
          dense(at(2 * row + 1), at(each.first + i)) = rows.imaginary()[place] = normal(random);
        }
      }
      rows.add(first, second);
    }
    rows.finish();
    const Eigen::MatrixXd expected = dense.transpose() * dense;
    const Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>> found(rows.values(), at(columns), at(columns),
                                                                           Eigen::OuterStride<>(at(rows.stride())));
    for (Eigen::Index c = 0; c < expected.cols(); ++c) {
      for (Eigen::Index r = c; r < expected.rows(); ++r) RC_ASSERT(std::abs(found(r, c) - expected(r, c)) <= 1e-12);
    }
  }
}

/// The right factor in all its forms, the left one as it is and conjugated.
RC_GTEST_PROP(LaneMatrix, AddsProducts, (unsigned seed, bool transposed, bool conjugated, bool left_conjugated)) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const auto size = [&random] { return std::uniform_int_distribution<std::size_t>(1, 11)(random); };
  const std::size_t rows = size(), depth = size(), columns = size();
  const auto any = [&](std::size_t m, std::size_t n) -> Eigen::MatrixXcd {
    return Eigen::MatrixXcd::NullaryExpr(at(m), at(n), [&] { return Complex(normal(random), normal(random)); });
  };
  const auto lanes = [](const Eigen::MatrixXcd& of) {
    return LaneMatrix(static_cast<std::size_t>(of.rows()), static_cast<std::size_t>(of.cols()),
                      [&of](std::size_t i, std::size_t j) { return of(at(i), at(j)); });
  };
  const Eigen::MatrixXcd start = any(rows, columns), a = any(rows, depth),
                         b = transposed ? any(columns, depth) : any(depth, columns);
  LaneMatrix sum = lanes(start);
  const LaneMatrix left = lanes(a), right = lanes(b);
  sum.add_product(
      left_conjugated ? left.conjugate() : left.plain(),
      transposed ? (conjugated ? right.adjoint() : right.transpose()) : (conjugated ? right.conjugate() : right.plain()), -1.0);
  Eigen::MatrixXcd factor = transposed ? Eigen::MatrixXcd(b.transpose()) : b;
  if (conjugated) factor = factor.conjugate().eval();
  const Eigen::MatrixXcd expected = start - (left_conjugated ? Eigen::MatrixXcd(a.conjugate()) : a) * factor;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j)
      RC_ASSERT(std::abs(sum(i, j) - expected(at(i), at(j))) <= 1e-13 * (1.0 + expected.norm()));
  }
}

/// Sizes beyond 128 take wider panels.
RC_GTEST_PROP(NormalKernels, EliminateLikeCholeskyFactors, (unsigned seed)) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const std::size_t v = std::uniform_int_distribution<std::size_t>(1, seed % 8 == 0 ? 150 : 40)(random);
  const std::size_t rest = std::uniform_int_distribution<std::size_t>(1, 25)(random), size = v + rest, stride = widths_of(size);
  const Eigen::MatrixXd rows = Eigen::MatrixXd::NullaryExpr(at(2 * size), at(size), [&] { return normal(random); });
  const Eigen::MatrixXd whole = rows.transpose() * rows, u = whole.topLeftCorner(at(v), at(v)), w = whole.topRightCorner(at(v), at(rest));
  std::vector<double> matrix(size * stride + kernel_width, 0.0), out(v * widths_of(rest));
  using Strided = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
  Strided there(matrix.data(), at(size), at(size), Eigen::OuterStride<>(at(stride)));
  there = whole;
  RC_ASSERT(eliminate(matrix.data(), stride, v, size));
  solve_eliminated(matrix.data(), stride, v, size, out.data());
  const Eigen::MatrixXd solved = dense::solve_positive(u, w);
  const Eigen::Map<const RowMatrixXd, 0, Eigen::OuterStride<>> found(out.data(), at(v), at(rest),
                                                                     Eigen::OuterStride<>(at(widths_of(rest))));
  RC_ASSERT((found - solved).norm() <= 1e-9 * solved.norm());
  const Eigen::MatrixXd schur = whole.bottomRightCorner(at(rest), at(rest)) - w.transpose() * solved;
  const Eigen::MatrixXd told = there.bottomRightCorner(at(rest), at(rest)).selfadjointView<Eigen::Lower>();
  RC_ASSERT((told - schur).norm() <= 1e-9 * whole.norm());
  Eigen::VectorXd one = w.col(0);
  solve_by_factor(matrix.data(), stride, v, one.data());
  RC_ASSERT((one - solved.col(0)).norm() <= 1e-9 * solved.norm());
  there = whole;
  there(at(v) - 1, at(v) - 1) = -1.0;
  RC_ASSERT(!eliminate(matrix.data(), stride, v, size));
}

/// A joint with all four matrices, some of their elements known, in two bands.
struct FourMatrices {
  FourMatrices() {
    spec = joint_of(dofs({"1:+X", "2:+X", "3:+X"}), Kind::stiffness, Pattern::symmetric);
    spec.matrices[Kind::mass] = restrictions::EntryMatrix{{2.0, 0.0, "-m"}, {0.0, "m", 0.5}, {"-m", 0.5, "n+2*m-1"}};
    spec.matrices[Kind::viscous_damping] = Pattern::diagonal;
    spec.matrices[Kind::hysteretic_damping] = restrictions::EntryMatrix{{"d", 1.0, 0.0}, {1.0, "d", 0.0}, {0.0, 0.0, 3.0}};
    spec.bands_hz = {{1.0, 2.0}, {2.0, 3.0}};
    restriction = restrictions::build({spec});
  }

  restrictions::JointSpec spec;
  restrictions::Restriction restriction;
};

/// Z = K − ω²M + i(ωC + D) of the unknowns y in SI units (docs/formulas.md §1).
ComplexMatrix impedance(const restrictions::Restriction& restriction, const std::vector<double>& y, double omega) {
  const auto k = restriction.matrix(Kind::stiffness, y), m = restriction.matrix(Kind::mass, y);
  const auto c = restriction.matrix(Kind::viscous_damping, y), d = restriction.matrix(Kind::hysteretic_damping, y);
  const auto n = restriction.dofs.size();
  ComplexMatrix z(at(n), at(n));
  for (std::size_t i = 0; i < n * n; ++i) {
    z(at(i / n), at(i % n)) = Complex(k[i] - omega * omega * m[i], omega * c[i] + d[i]);
  }
  return z;
}

RC_GTEST_PROP(JointImpedance, IsThatOfTheMatrices, (unsigned seed)) {
  const FourMatrices sample;
  const UnknownColumns columns(sample.restriction, {sample.spec});
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const double omega0 = 40.0, hz = std::uniform_real_distribution<double>(1.0, 3.0)(random), omega = 2.0 * M_PI * hz;
  std::vector<double> theta, y(sample.restriction.unknowns.size());
  for (std::size_t i = 0; i < columns.size(); ++i) theta.push_back(normal(random));
  for (const std::size_t column : columns.at(hz)) {
    const Kind kind = sample.restriction.unknowns[columns.unknown_of(column)].kind;
    const double unit = kind == Kind::mass ? omega0 * omega0 : kind == Kind::viscous_damping ? omega0 : 1.0;
    y[columns.unknown_of(column)] = theta[column] / unit;
  }
  const JointImpedance joint = joint_at(sample.restriction, columns, omega0, omega);
  const ComplexMatrix z = joint.at(theta), expected = impedance(sample.restriction, y, omega);
  RC_ASSERT(joint.columns() == columns.at(hz));
  RC_ASSERT((z - expected).norm() <= 1e-13 * expected.norm());
  Eigen::VectorXcd left(3), right(3), found(at(joint.columns().size()));
  for (Eigen::Index i = 0; i < 3; ++i) left[i] = {normal(random), normal(random)};
  for (Eigen::Index i = 0; i < 3; ++i) right[i] = {normal(random), normal(random)};
  joint.sensitivity(left.data(), right.data(), found.data());
  for (std::size_t t = 0; t < joint.columns().size(); ++t) {
    std::vector<double> more = theta;
    more[joint.columns()[t]] += 1.0;
    const Complex change = (left.transpose() * (joint.at(more) - z) * right).value();
    RC_ASSERT(std::abs(found[at(t)] - change) <= 1e-12 * (1.0 + z.norm()));
  }
}

TEST(JointImpedance, HasNoColumnsOutsideOfTheBands) {
  const FourMatrices sample;
  const UnknownColumns columns(sample.restriction, {sample.spec});
  EXPECT_TRUE(joint_at(sample.restriction, columns, 40.0, 2.0 * M_PI * 5.0).columns().empty());
}

TEST(Covariance, IsTheInverseWhateverTheUnits) {
  Eigen::MatrixXd root(3, 3);
  root << 1.0, 0.3, -0.2, 0.0, 2.0, 0.5, 0.0, 0.0, 0.7;
  const Eigen::Vector3d unit(1e-9, 1.0, 1e6);
  const Eigen::MatrixXd information = unit.asDiagonal() * (root.transpose() * root) * unit.asDiagonal();
  const Eigen::MatrixXd product =
      unit.asDiagonal() * minimise::covariance_of(information) * information * unit.cwiseInverse().asDiagonal();
  EXPECT_LT((product - Eigen::Matrix3d::Identity()).norm(), 1e-12);
}

TEST(Covariance, OfAnUnknownWithoutInformationIsHuge) {
  Eigen::Matrix2d information;
  information << 1.0, 1.0, 1.0, 1.0;
  EXPECT_GT(minimise::covariance_of(information)(0, 0), 1e12);
}

TEST(FrfWeight, IsOneOverSigmaWithinWhatArithmeticCanUse) {
  EXPECT_EQ(frf_weight({4.0, 0.25}, 1.0), Complex(0.5, 2.0));
  EXPECT_EQ(frf_weight({1.0, 0.0}, 0.0), Complex(1.0, 1e4));
  EXPECT_EQ(frf_weight({0.0, 0.0}, 2.0), Complex(0.5e8, 0.5e8));
  EXPECT_EQ(frf_weight({0.0, 0.0}, 0.0), Complex(0.0));
  EXPECT_EQ(frf_weight({std::nan(""), std::nan("")}, 1.0), Complex(0.0));
}

}  // namespace
}  // namespace jointid::ident

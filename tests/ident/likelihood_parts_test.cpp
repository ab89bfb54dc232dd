#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "base/eigen.hpp"
#include "ident/likelihood/line/frf_weight.hpp"
#include "ident/likelihood/line/normal_rows.hpp"
#include "likelihood_line_sample.hpp"
#include "memory_systems.hpp"
#include "minimise/linear/covariance.hpp"

namespace jointid::ident {
namespace {

using restrictions::Kind;
using restrictions::Pattern;

RC_GTEST_PROP(NormalRows, AddUpToTheProductOfTheDenseMatrix, (unsigned seed)) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const auto columns = *rc::gen::inRange<std::size_t>(1, 20), count = *rc::gen::inRange<std::size_t>(0, 8);
  NormalRows rows;
  rows.reset(columns);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(at(2 * count), at(columns));
  for (std::size_t row = 0; row < count; ++row) {
    std::array<std::size_t, 6> cut;
    for (std::size_t& c : cut) c = std::uniform_int_distribution<std::size_t>(0, columns)(random);
    std::sort(cut.begin(), cut.end());
    std::array<NormalRows::Run, 3> runs;
    std::size_t place = 0;
    for (std::size_t r = 0; r < 3; ++r) {
      runs[r] = {cut[2 * r], cut[2 * r + 1] - cut[2 * r]};
      for (std::size_t i = 0; i < runs[r].count; ++i, ++place) {
        dense(at(2 * row), at(runs[r].first + i)) = rows.real()[place] = normal(random);
        dense(at(2 * row + 1), at(runs[r].first + i)) = rows.imaginary()[place] = normal(random);
      }
    }
    rows.add(runs);
  }
  const Eigen::MatrixXd expected = dense.transpose() * dense;
  const Eigen::Map<const Eigen::MatrixXd> found(rows.data(), at(columns), at(columns));
  for (Eigen::Index c = 0; c < expected.cols(); ++c) {
    for (Eigen::Index r = c; r < expected.rows(); ++r) RC_ASSERT(std::abs(found(r, c) - expected(r, c)) <= 1e-12);
  }
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
  const JointImpedance joint(sample.restriction, columns, omega0, omega);
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
  EXPECT_TRUE(JointImpedance(sample.restriction, columns, 40.0, 2.0 * M_PI * 5.0).columns().empty());
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

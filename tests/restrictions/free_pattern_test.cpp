#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "dense/pivoted_qr.hpp"
#include "tests/restrictions/joints.hpp"

namespace jointid::restrictions {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using ::testing::Each;
using ::testing::ElementsAre;
using Positions = std::map<std::int64_t, std::array<double, 3>>;

/// Motion of the DOFs under a small rigid translation t and rotation θ about the origin (not the centroid).
Eigen::VectorXd rigid_motion(const std::vector<frf::Dof>& all, const Positions& positions, const Vector3d& t,
                             const Vector3d& theta) {
  Eigen::VectorXd q(static_cast<Index>(all.size()));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Vector3d moved = t + theta.cross(Vector3d(positions.at(all[i].node).data()));
    const auto code = static_cast<Index>(all[i].direction) - 1;
    q(static_cast<Index>(i)) = all[i].sign * (code < 3 ? moved(code) : theta(code - 3));
  }
  return q;
}

MatrixXd rigid_motions(const std::vector<frf::Dof>& all, const Positions& positions) {
  MatrixXd motions(static_cast<Index>(all.size()), 6);
  for (Index i = 0; i < 3; ++i) {
    motions.col(i) = rigid_motion(all, positions, Vector3d::Unit(i), Vector3d::Zero());
    motions.col(i + 3) = rigid_motion(all, positions, Vector3d::Zero(), Vector3d::Unit(i));
  }
  return motions;
}

/// One column per unknown: the matrix that the unknown alone makes.
MatrixXd images(const Restriction& r) {
  const auto size = static_cast<Index>(r.dofs.size() * r.dofs.size());
  MatrixXd columns(size, static_cast<Index>(r.unknowns.size()));
  for (std::size_t i = 0; i < r.unknowns.size(); ++i) {
    std::vector<double> y(r.unknowns.size(), 0.0);
    y[i] = 1.0;
    const std::vector<double> x = r.matrix(Kind::stiffness, y);
    columns.col(static_cast<Index>(i)) = Eigen::Map<const Eigen::VectorXd>(x.data(), size);
  }
  return columns;
}

Restriction build_free(const std::vector<frf::Dof>& all, const Positions& positions) {
  JointSpec spec = joint(all, Kind::stiffness, Pattern::free);
  spec.node_positions = positions;
  return build({spec});
}

TEST(FreePattern, TwoNodesInLineLeaveOneSpring) {
  const Restriction r = build_free(dofs({"1:+X", "2:+X"}), {{1, {0, 0, 0}}, {2, {0.3, 0, 0}}});
  EXPECT_THAT(names(r), ElementsAre("K.s(1,1)"));
  EXPECT_THAT(units(r), ElementsAre("N/m"));
  const std::vector<double> x = r.matrix(Kind::stiffness, {2.0});
  EXPECT_NEAR(x[0], 1.0, 1e-15);
  EXPECT_NEAR(x[1], -1.0, 1e-15);
  EXPECT_NEAR(x[3], 1.0, 1e-15);
  EXPECT_TRUE(r.symmetric());
}

TEST(FreePattern, TheBeamElementOfTheThesisIsInItsSpace) {
  // K of thesis §6.6 with L = 0.3: shear forces balance and their moment is that of the end moments.
  const double k = 662400, l = 0.3;
  const double s = k * l / 2, d = k * l * l / 3, o = k * l * l / 6;
  Eigen::VectorXd x(16);
  x << k, s, -k, s, s, d, -s, o, -k, -s, k, -s, s, o, -s, d;
  const Restriction r = build_free(beam_dofs(), {{4, {1, 0, 0}}, {5, {1 + l, 0, 0}}});
  EXPECT_THAT(names(r), ElementsAre("K.s(1,1)", "K.s(1,2)", "K.s(2,2)"));
  const MatrixXd t = images(r);
  const Eigen::VectorXd y = dense::RealPivotedQr(t).solve(x);
  EXPECT_LE((t * y - x).norm(), 1e-13 * x.norm());
}

TEST(FreePattern, CoincidentNodesLeaveTheirRelativeMotion) {
  const std::vector<frf::Dof> all = dofs({"1:+X", "1:+Y", "1:+RZ", "2:+X", "2:+Y", "2:+RZ"});
  const Restriction r = build_free(all, {{1, {0.1, 0.7, -3}}, {2, {0.1, 0.7, -3}}});
  EXPECT_EQ(r.unknowns.size(), 6u);
  EXPECT_THAT(units(r), Each("N/m"));
}

TEST(FreePattern, NodesInLineFarFromTheOriginAreStillInLine) {
  // Nine translations; the turn about the line moves none of them: 9 − 5 deformations.
  const std::vector<frf::Dof> all =
      dofs({"1:+X", "1:+Y", "1:+Z", "2:+X", "2:+Y", "2:+Z", "3:+X", "3:+Y", "3:+Z"});
  const Restriction r =
      build_free(all, {{1, {70.1, -30.1, 10.1}}, {2, {70.2, -30.3, 10.4}}, {3, {70.3, -30.5, 10.7}}});
  EXPECT_EQ(r.unknowns.size(), 10u);
}

/// Rank by elimination in whole numbers (Bareiss), so that no tolerance enters.
std::size_t exact_rank(std::vector<std::array<std::int64_t, 6>> rows) {
  std::size_t rank = 0;
  std::int64_t previous = 1;
  for (std::size_t column = 0; column < 6 && rank < rows.size(); ++column) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(rank), rows.end(),
                                    [&](const auto& row) { return row[column] != 0; });
    if (pivot == rows.end()) continue;
    std::swap(rows[rank], *pivot);
    for (std::size_t i = rank + 1; i < rows.size(); ++i) {
      for (std::size_t j = column + 1; j < 6; ++j) {
        rows[i][j] = (rows[i][j] * rows[rank][column] - rows[i][column] * rows[rank][j]) / previous;
      }
      rows[i][column] = 0;
    }
    previous = rows[rank][column];
    ++rank;
  }
  return rank;
}

/// DOFs at nodes whose coordinates are whole multiples of a unit.
struct Case {
  std::vector<frf::Dof> dofs;
  std::map<std::int64_t, std::array<double, 3>> whole;  ///< coordinates in that unit
};

Case some_case(bool planar) {
  const std::vector<std::string> directions =
      planar ? std::vector<std::string>{"X", "Y", "RZ"} : std::vector<std::string>{"X", "Y", "Z", "RX", "RY", "RZ"};
  Case result;
  const auto nodes = *rc::gen::inRange<std::int64_t>(2, 5);
  for (std::int64_t node = 1; node <= nodes; ++node) {
    const auto at = *rc::gen::container<std::vector<int>>(3, rc::gen::inRange(-9, 10));
    result.whole[node] = {1.0 * at[0], 1.0 * at[1], planar ? 0.0 : 1.0 * at[2]};
    const auto kept =  // 1: flipped, 3: left out
        *rc::gen::container<std::vector<int>>(directions.size(), rc::gen::inRange(0, 4));
    for (std::size_t i = 0; i < directions.size(); ++i) {
      if (kept[i] == 3) continue;
      result.dofs.push_back(frf::Dof::parse(std::to_string(node) + (kept[i] == 1 ? ":-" : ":+") + directions[i]));
    }
  }
  return result;
}

std::size_t complement_dimension(const Case& some) {
  const MatrixXd motions = rigid_motions(some.dofs, some.whole);
  std::vector<std::array<std::int64_t, 6>> rows;
  for (Index i = 0; i < motions.rows(); ++i) {
    rows.emplace_back();
    for (Index j = 0; j < 6; ++j) rows.back()[static_cast<std::size_t>(j)] = std::llround(motions(i, j));
  }
  return rows.size() - exact_rank(rows);
}

RC_GTEST_PROP(FreePattern, NoForceUnderRigidMotionAndAsManyUnknownsAsTheComplementHas, (bool planar, bool far)) {
  const Case some = some_case(planar);
  RC_PRE(!some.dofs.empty());
  const std::size_t dimension = complement_dimension(some);
  RC_PRE(dimension > 0u);
  Positions positions = some.whole;
  for (auto& [node, position] : positions) {
    for (double& x : position) x = 0.1 * x + (far ? 300.7 : 0.0);
  }

  const Restriction r = build_free(some.dofs, positions);
  RC_ASSERT(r.unknowns.size() == dimension * (dimension + 1) / 2);
  RC_ASSERT(r.symmetric());
  const MatrixXd columns = images(r);
  RC_ASSERT(dense::RealPivotedQr(columns).rank() == columns.cols());
  const MatrixXd motions = rigid_motions(some.dofs, positions);
  for (Index i = 0; i < columns.cols(); ++i) {
    const Eigen::Map<const MatrixXd> x(columns.col(i).data(), motions.rows(), motions.rows());
    RC_ASSERT((x * motions).norm() <= 1e-13 * x.norm() * motions.norm());
  }
}

}  // namespace
}  // namespace jointid::restrictions

#include "response/comparison/compare_ways.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "friction/law/laws.hpp"
#include "problems/thesis/two_beams.hpp"
#include "response/structure/modal_damping.hpp"

namespace jointid::response {
namespace {

Eigen::MatrixXd dense_matrix(const problems::Matrix& rows) {
  Eigen::MatrixXd all(at(rows.size()), at(rows.size()));
  for (Eigen::Index i = 0; i < all.rows(); ++i) {
    for (Eigen::Index j = 0; j < all.cols(); ++j) all(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }
  return all;
}

MatrixAssembly beams(const std::string& name) {
  const problems::TwoBeams& type = *problems::find_two_beams(name);
  const Eigen::MatrixXd mass = dense_matrix(problems::two_beams_mass()),
                        stiffness = dense_matrix(problems::two_beams_stiffness());
  MatrixAssembly all = {{mass, modal_damping(mass, stiffness, 0.01), stiffness}, Eigen::MatrixXd::Zero(18, 2), {}, {}};
  all.w(4, 0) = all.w(6, 1) = 1.0;
  all.w(12, 0) = -1.0;
  all.joints.assign(2, {.name = "joint", .friction = friction::make_element(type.law, type.parameters)});
  all.forces = Eigen::VectorXd::Unit(18, 4);
  return all;
}

/// What the thesis says of type B (§11 of the formula sheet): the first harmonic alone is 19 % low, nine harmonics 0.37 %.
TEST(CompareWays, OfTypeBIsThatOfTheThesis) {
  const auto ways = compare_ways(beams("beams-B"), Excitation::single(Complex(0.0, -1.0)), 100.0 * std::numbers::pi, 1.0,
                                 Eigen::VectorXd::Unit(18, 4), {.largest_harmonics = {1, 9}, .steps_per_period = {100, 200}});
  ASSERT_EQ(ways.size(), 7u);
  for (const WayResult& way : ways) ASSERT_TRUE(way.found) << way.way;
  EXPECT_NEAR(ways[0].largest, 1.859820e-6, 1e-12);
  EXPECT_NEAR(ways[1].of_largest, -0.19, 0.005);
  EXPECT_NEAR(ways[2].of_largest, -0.0037, 0.0001);
  EXPECT_LT(ways[2].of_motion, 0.02);
  EXPECT_LT(ways[3].of_motion, 0.06);
  EXPECT_LT(ways[4].of_motion, 0.4 * ways[3].of_motion);  // of order 2
  EXPECT_LT(ways[6].of_motion, 0.5 * ways[5].of_motion);
  EXPECT_LT(ways[0].of_motion, 1e-10);
}

/// A linear structure has one harmonic, and nothing between the ways but rounding and the steps.
TEST(CompareWays, OfALinearStructureAgree) {
  const auto ways = compare_ways(beams("beams-A"), Excitation::single(Complex(0.0, -1.0)), 100.0 * std::numbers::pi, 1.0,
                                 Eigen::VectorXd::Unit(18, 4), {.largest_harmonics = {1, 3}, .steps_per_period = {}});
  ASSERT_EQ(ways.size(), 3u);
  for (const WayResult& way : ways) {
    ASSERT_TRUE(way.found) << way.way;
    EXPECT_LT(way.of_motion, 1e-8) << way.way;
    EXPECT_NEAR(way.largest, 2.472486e-6, 3e-12);
  }
}

}  // namespace
}  // namespace jointid::response

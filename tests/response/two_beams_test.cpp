#include "problems/thesis/two_beams.hpp"

#include <gtest/gtest.h>

#include "tests/require.hpp"
#include "tests/response/golden.hpp"

namespace jointid::response {
namespace {

/// Largest difference over the largest element.
double difference(const problems::Matrix& found, const Eigen::MatrixXd& expected) {
  Eigen::MatrixXd own(expected.rows(), expected.cols());
  for (Eigen::Index i = 0; i < own.rows(); ++i) {
    for (Eigen::Index j = 0; j < own.cols(); ++j) own(i, j) = found[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }
  return (own - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

TEST(TwoBeams, AreThoseOfTheGoldenValues) {
  const auto cases = golden::cases("thesis_18dof");
  if (cases.empty()) JOINTID_SKIP("no reference file " << golden::file());
  EXPECT_LE(difference(problems::two_beams_mass(), golden::matrix(cases[0]["M"])), 1e-13);
  EXPECT_LE(difference(problems::two_beams_stiffness(), golden::matrix(cases[0]["K"])), 1e-13);
  for (const problems::TwoBeams& each : problems::list_two_beams()) {
    const auto& type = cases[0]["joint_types"][each.name.substr(6)];
    EXPECT_EQ(each.law, type["law"]);
    EXPECT_EQ(each.parameters, type["parameters"].get<std::vector<double>>());
  }
}

}  // namespace
}  // namespace jointid::response

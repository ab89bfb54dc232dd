#include "response/condensation/condensation.hpp"

#include <gtest/gtest.h>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "golden_motions.hpp"
#include "response/orbit/orbit_figures.hpp"

namespace jointid::response {
namespace {

using Eigen::VectorXd;
using nlohmann::json;

TEST(Condensation, MeetsTheGoldenErrors) {
  for_each_golden("thesis_18dof", [](const json& one) {
    JointedStructure whole = jointed(one);
    whole.laws = {golden::element(one.at("joint_types").at("B")), golden::element(one.at("joint_types").at("B"))};
    for (const json& row : one.at("condensation_B")) {
      const std::string kind = row.at("kind");
      const Eigen::Index modes = row.at("modes");
      SCOPED_TRACE(kind + " " + std::to_string(modes));
      const Basis basis = kind == "free"   ? free_modes(whole, modes)
                          : kind == "lock" ? lock_modes(whole, modes, whole.initial_stiffness())
                                           : free_and_attachment_modes(whole, modes);
      PeriodicProblem problem{condense(whole, basis), one.at("omega"), {1}, {}};
      problem.amplitudes = basis.columns.transpose() * (Complex(0.0, -1.0) * VectorXd::Unit(18, 4));
      const PeriodicOrbit orbit = find_orbit(problem);
      ASSERT_TRUE(orbit.closed);
      const OrbitFigures found = figures(problem, orbit, {1, 3});
      const Eigen::VectorXcd x5 = (basis.columns.row(4) * found.x).transpose(), q2 = found.q.row(1).transpose();
      EXPECT_LT(difference(x5, complex_vector(row.at("X5"))), 1e-9);
      EXPECT_LT(difference(q2, complex_vector(row.at("Q2"))), 1e-9);
      // Told with three digits, against the motion on all modes.
      const Complex all = golden::complex(one.at("type_B").at("steady").at("X5")[0]);
      EXPECT_NEAR(std::abs(x5(0) - all) / std::abs(all), row.at("error_X5").get<double>(), 6e-3 * row.at("error_X5").get<double>() + 1e-9);
    }
  });
}

// Three masses in a chain that nothing holds: attachment columns are static deflections without rigid-body motion.
TEST(Condensation, OfAFreeStructureHoldsItsStaticDeflection) {
  JointedStructure chain;
  chain.matrices.mass = Eigen::Vector4d(1.0, 2.0, 1.0, 3.0).asDiagonal();
  chain.matrices.stiffness.setZero(4, 4);
  for (int i = 0; i < 3; ++i)
    chain.matrices.stiffness.block<2, 2>(i, i) += 50.0 * (i + 1) * Eigen::Matrix2d{{1.0, -1.0}, {-1.0, 1.0}};
  chain.matrices.damping = 0.01 * chain.matrices.stiffness;
  chain.incidence = Eigen::Vector4d(1.0, 0.0, 0.0, -1.0);
  chain.laws = {friction::make_element("spring", std::vector<double>{1.0})};
  const Basis basis = free_and_attachment_modes(chain, 1);
  ASSERT_EQ(basis.columns.cols(), 2);
  const JointedStructure small = condense(chain, basis);
  EXPECT_LT((small.matrices.mass - Eigen::Matrix2d::Identity()).cwiseAbs().maxCoeff(), 1e-14);
  // The joint's force stretches the chain by Wᵀ K⁺ W; the rigid-body mode does not move it.
  const double flexibility = small.incidence(1, 0) * small.incidence(1, 0) / small.matrices.stiffness(1, 1);
  EXPECT_NEAR(flexibility, 1.0 / 50.0 + 1.0 / 100.0 + 1.0 / 150.0, 1e-13);
  EXPECT_EQ(free_and_attachment_modes(chain, 4).attachments, 0);
  EXPECT_THROW(free_modes(chain, 5), InputError);
}

/// Columns are M-orthonormal, so that their Rayleigh quotients are ω².
TEST(Condensation, ModesHaveTheFrequenciesOfTheThesissBeams) {
  for_each_golden("thesis_18dof", [](const json& one) {
    JointedStructure beams = jointed(one);
    beams.laws.assign(2, golden::element(one.at("joint_types").at("A")));
    const Eigen::MatrixXd &free = beams.matrices.stiffness,
                          locked = free + 1e6 * beams.incidence * beams.incidence.transpose();
    const auto hertz_of = [](const Basis& basis, const Eigen::MatrixXd& stiffness) {
      return Eigen::VectorXd((basis.columns.transpose() * stiffness * basis.columns).diagonal().cwiseSqrt() / angular(1.0));
    };
    const json& expected = one.at("modes_hz");
    EXPECT_LT(difference(hertz_of(free_modes(beams, 6), free), vector(expected.at("free"))), 1e-10);
    EXPECT_LT(difference(hertz_of(lock_modes(beams, 6, Eigen::Vector2d(1e6, 1e6)), locked), vector(expected.at("lock_1e6"))), 1e-10);
  });
}

}  // namespace
}  // namespace jointid::response

#include "response/condensation/condensation.hpp"

#include <gtest/gtest.h>

#include "golden.hpp"
#include "response/orbit/orbit_figures.hpp"

namespace jointid::response {
namespace {

using Eigen::VectorXd;
using nlohmann::json;

TEST(Condensation, MeetsTheGoldenErrors) {
  for_each_golden("thesis_18dof", [](const json& one) {
    JointedStructure whole = jointed(one);
    whole.laws = {law(one.at("joint_types").at("B")), law(one.at("joint_types").at("B"))};
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
      ASSERT_EQ(orbit.status, OrbitStatus::closed);
      const OrbitFigures found = figures(problem, orbit, {1, 3});
      const Eigen::VectorXcd x5 = (basis.columns.row(4) * found.x).transpose(), q2 = found.q.row(1).transpose();
      EXPECT_LT(difference(x5, complex_vector(row.at("X5"))), 1e-9);
      EXPECT_LT(difference(q2, complex_vector(row.at("Q2"))), 1e-9);
      printf("%s %ld+%ld: %g %g newton %d\n", kind.c_str(), basis.modes, basis.attachments, difference(x5, complex_vector(row.at("X5"))), difference(q2, complex_vector(row.at("Q2"))), orbit.newton_steps);
    }
  });
}

}  // namespace
}  // namespace jointid::response

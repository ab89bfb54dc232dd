#include "friction/joint/fe_joint.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "base/error.hpp"
#include "friction/law/bending_root.hpp"
#include "friction/joint/fe_cases.hpp"
#include "friction/law/laws.hpp"
#include "friction/law/menq_bar.hpp"
#include "friction/path/masing_path.hpp"

namespace jointid::friction {
namespace {

/// Largest relative difference of the forces along a history of displacements to Menq's formula with Masing's rule.
double difference_to_menq(const MenqBar::Values& values, std::size_t members, const std::vector<double>& history) {
  const MenqBar bar(values);
  MasingPath path(bar);
  FiniteElementJoint joint(menq_mesh(values, members));
  double worst = 0.0, largest = 0.0;
  for (const double u : history) {
    const EquilibriumStep step = joint.move_to(u);
    EXPECT_TRUE(step.found);
    const double exact = path.advance(u).force;
    worst = std::max(worst, std::abs(step.force - exact));
    largest = std::max(largest, std::abs(exact));
  }
  return worst / largest;
}

TEST(FiniteElementJoint, ConvergesToMenqWithOrderTwo) {
  for (const double spring : {0.0, 2e7}) {
    MenqBar::Values values = case_one();
    values.length = 0.2;
    values.end_spring = spring;
    const double last = MenqBar(values).kinks().back();
    std::vector<double> history;
    for (int i = 1; i <= 30; ++i) history.push_back(0.04 * i * last);
    for (int i = 1; i <= 30; ++i) history.push_back((1.2 - 0.08 * i) * last);
    const double coarse = difference_to_menq(values, 20, history), fine = difference_to_menq(values, 160, history);
    EXPECT_LT(fine, 1e-4);
    EXPECT_NEAR(std::log(coarse / fine) / std::log(8.0), 2.0, 0.05) << coarse << ' ' << fine;
  }
}

// A stiff interface is dry friction. The two slip zones of the closed form both move forward, although the friction of one of
// them pushes forward: with friction against the motion everywhere the joint is a little stiffer.
TEST(FiniteElementJoint, OfABeamIsALittleStifferThanTheBendingRoot) {
  const double ei = 100.0, tau = 1e4, free_length = 0.1, force = 200.0;
  const BendingRoot root(ei, tau, free_length);
  const double clamp = 1.5 * root.slipped_length(force);
  const auto softer = [&](std::size_t members) {
    const auto dry = std::shared_ptr(make_element("bilinear", std::array{1e-9, tau / 1e-9}));
    JointMesh mesh = uniform_mesh(MemberKind::beam, members, {clamp, ei}, dry);
    mesh.members.push_back({free_length, ei});
    mesh.interface.push_back(nullptr);
    FiniteElementJoint joint(mesh);
    const EquilibriumStep step = joint.load_to(force);
    EXPECT_TRUE(step.found);
    const std::vector<double> u = joint.displacements(), friction = joint.interface_forces();
    for (std::size_t i = 0; i < u.size(); ++i) EXPECT_GE(friction[i] * u[i], 0.0);
    return root.displacement(force) / step.displacement - 1.0;
  };
  EXPECT_NEAR(softer(200), 0.037, 0.002);
  EXPECT_NEAR(softer(200), softer(100), 2e-4);
}

TEST(FiniteElementJoint, ForcesAreInBalance) {
  FiniteElementJoint joint(case_two());
  for (const double force : {400.0, -300.0, 200.0, 700.0}) {
    const EquilibriumStep step = joint.load_to(force);
    ASSERT_TRUE(step.found);
    const std::vector<double> forces = joint.interface_forces();
    EXPECT_NEAR(std::accumulate(forces.begin(), forces.end(), 0.0), force, 1e-8 * std::abs(force));
    EXPECT_EQ(joint.displacements().back(), step.displacement);
  }
}

// Elastic members and sliders: the whole obeys Masing's rule, whatever the interface.
TEST(FiniteElementJoint, CaseTwoObeysMasing) {
  FiniteElementJoint joint(case_two());
  const EquilibriumStep top = joint.load_to(1000.0), low = joint.load_to(-600.0);
  const auto initial = [](double force) { return FiniteElementJoint(case_two()).load_to(force).displacement; };
  EXPECT_NEAR(top.displacement - low.displacement, 2.0 * initial(800.0), 1e-9 * top.displacement);
  const EquilibriumStep again = joint.load_to(1000.0);
  EXPECT_NEAR(again.displacement, top.displacement, 1e-9 * top.displacement);
}

TEST(FiniteElementJoint, DoesNotDependOnTheSteps) {
  FiniteElementJoint once(case_two()), often(case_two());
  for (int i = 1; i <= 20; ++i) often.load_to(50.0 * i);
  EXPECT_NEAR(once.load_to(1000.0).displacement, often.displacements().back(), 1e-9 * often.displacements().back());
}

TEST(FiniteElementJoint, SaysWhenTheLoadIsBeyondTheLimit) {
  const MenqBar::Values values = case_one();
  FiniteElementJoint joint(menq_mesh(values, 20));
  const double limit = values.slip_force * values.length;
  EXPECT_TRUE(joint.load_to(0.99 * limit).found);
  const EquilibriumStep beyond = joint.load_to(1.01 * limit);
  EXPECT_FALSE(beyond.found);
  EXPECT_NEAR(beyond.force, limit, 1e-4 * limit);
  EXPECT_LT(beyond.displacement, 1.001 * MenqBar(values).kinks().back());
  EXPECT_NEAR(joint.move_to(10.0 * MenqBar(values).kinks().back()).force, limit, 1e-9 * limit);
}

// Thesis 2.16.2.3: on a soft component the law of the interface matters little, on a stiff one it does.
TEST(FiniteElementJoint, CaseThreeShowsMacroAndMicroMicroslip) {
  const auto spread = [](double length) {
    const double limit = make_element("ren", std::array{5e-8, 3.0, 2e12})->limit() * 0.01 * length;
    std::vector<double> u;
    for (const CaseThreeLaw law : {CaseThreeLaw::ren, CaseThreeLaw::same_stiffness, CaseThreeLaw::same_macroslip}) {
      u.push_back(FiniteElementJoint(case_three(law, length, 400)).load_to(0.6 * limit).displacement);
    }
    const auto [least, most] = std::minmax_element(u.begin(), u.end());
    return *most / *least - 1.0;
  };
  EXPECT_LT(spread(1.0), 0.15);
  EXPECT_GT(spread(0.1), 0.4);
}

TEST(FiniteElementJoint, WrongMeshesAreRefused) {
  EXPECT_THROW(FiniteElementJoint(JointMesh{}), InputError);
  JointMesh mesh = case_two();
  mesh.interface.pop_back();
  EXPECT_THROW(FiniteElementJoint{mesh}, InputError);
  mesh.interface.assign(21, nullptr);
  EXPECT_THROW(FiniteElementJoint{mesh}, InputError);
  mesh = case_two();
  mesh.members[3].length = 0.0;
  EXPECT_THROW(FiniteElementJoint{mesh}, InputError);
}

}  // namespace
}  // namespace jointid::friction

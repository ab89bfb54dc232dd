#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

#include "golden_motions.hpp"
#include "response/time/algorithm_one.hpp"
#include "response/time/algorithm_two.hpp"
#include "tests/response/any_joint.hpp"

namespace jointid::response {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using nlohmann::json;

ForceHistory sine(Eigen::Index size, Eigen::Index coordinate, double p, double omega) {
  return ForceHistory::periodic(omega, {1}, Complex(0.0, -1.0) * p * VectorXd::Unit(size, coordinate));
}

/// x and f (one column after every fifth of the run).
template <class Algorithm>
std::pair<MatrixXd, MatrixXd> fifths(Algorithm& algorithm, int steps) {
  MatrixXd x(algorithm.motion().x.size(), 5), f(algorithm.motion().f.size(), 5);
  for (int i = 1; i <= steps; ++i) {
    algorithm.step();
    if (i % (steps / 5) != 0) continue;
    x.col(i / (steps / 5) - 1) = algorithm.motion().x;
    f.col(i / (steps / 5) - 1) = algorithm.motion().f;
  }
  return {x, f};
}

TEST(Algorithms, MeetTheGoldenRuns) {
  for_each_golden("algorithms", [](const json& one) {
    SCOPED_TRACE(one.at("id").get<std::string>());
    const JointedStructure structure = jointed(one);
    const ForceHistory force = sine(3, 0, one.at("p"), one.at("omega"));
    for (const json& run : one.at("runs")) {
      AlgorithmOne first(structure, force, run.at("delta"));
      const auto [x1, f1] = fifths(first, run.at("steps"));
      EXPECT_LT(difference(x1, matrix(run.at("algorithm_one").at("x")).transpose()), tolerance(one));
      EXPECT_LT(difference(f1, matrix(run.at("algorithm_one").at("F")).transpose()), tolerance(one));
      AlgorithmTwo second(structure, force, run.at("delta"));
      const auto [x2, f2] = fifths(second, run.at("steps"));
      EXPECT_LT(difference(x2, matrix(run.at("algorithm_two").at("x")).transpose()), tolerance(one));
      EXPECT_LT(difference(f2, matrix(run.at("algorithm_two").at("F")).transpose()), tolerance(one));
      EXPECT_LE(static_cast<double>(first.solutions()) / run.at("steps").get<double>(),
                run.at("algorithm_one").at("newton_per_step").get<double>());
      EXPECT_LE(first.residual(), 1e-11);
      EXPECT_LE(second.growth(), 1.0);
      EXPECT_TRUE(second.too_soft().empty());
    }
  });
}

TEST(Algorithms, ErrWithTheSquareOfTheStep) {
  for_each_golden("algorithms", [](const json& one) {
    SCOPED_TRACE(one.at("id").get<std::string>());
    const JointedStructure structure = jointed(one);
    const ForceHistory force = sine(3, 0, one.at("p"), one.at("omega"));
    json rows = one.at("errors_by_halving");
    for (const json& run : one.at("runs")) {
      rows.push_back({run.at("delta"), run.at("error_one"), run.at("error_two"), run.at("error_two_rest_start")});
    }
    const double duration = one.at("runs")[0].at("delta").get<double>() * one.at("runs")[0].at("steps").get<double>();
    for (const json& row : rows) {
      const double delta = row[0];
      const int steps = static_cast<int>(std::lround(duration / delta));
      AlgorithmOne first(structure, force, delta);
      AlgorithmTwo second(structure, force, delta), from_rest(structure, force, delta, {.starts_by_algorithm_one = false});
      ExactMarch exact(structure, force);
      MatrixXd x(3, 5);
      for (int i = 0; i < 5; ++i) {
        ASSERT_TRUE(exact.march(delta * steps / 5 * (i + 1)));
        x.col(i) = exact.motion().x;
      }
      // Printed with three digits.
      const auto error = [&](auto& algorithm) { return (fifths(algorithm, steps).first - x).cwiseAbs().maxCoeff(); };
      EXPECT_NEAR(error(first) / row[1].get<double>(), 1.0, 6e-3);
      EXPECT_NEAR(error(second) / row[2].get<double>(), 1.0, 6e-3);
      EXPECT_NEAR(error(from_rest) / row[3].get<double>(), 1.0, 6e-3);
    }
  });
}

// Where the thesis had no convergence.
TEST(Algorithms, OneNeverFailsOnVeryStiffJoints) {
  for_each_golden("thesis_18dof", [](const json& one) {
    for (const std::string type : {"C", "D"}) {
      JointedStructure structure = jointed(one);
      structure.laws = {golden::element(one.at("joint_types").at(type)), golden::element(one.at("joint_types").at(type))};
      for (const double delta : {1e-3, 2e-4, 1e-5}) {
        AlgorithmOne first(structure, sine(18, 4, 1.0, one.at("omega")), delta);
        const int steps = static_cast<int>(0.04 / delta);
        for (int i = 0; i < steps; ++i) first.step();
        EXPECT_LE(first.most_solutions(), 20U);
        EXPECT_LE(static_cast<double>(first.solutions()) / steps, 4.0);
        EXPECT_LE(first.residual(), 1e-9);
      }
    }
  });
}

RC_GTEST_PROP(Algorithms, OneMeetsTheLawsOfAnyJointsAtAnyStep, ()) {
  JointedStructure structure = jointed(golden::cases("mdof_jenkins_exact").at(0));
  structure.laws = {any_joint(), any_joint()};
  AlgorithmOne first(structure, sine(3, 0, any_decade(0.1, 1e3), any_in(5.0, 25.0)), any_decade(1e-4, 1.0));
  for (int i = 0; i < 60; ++i) first.step();
  RC_ASSERT(first.motion().x.allFinite());
  RC_ASSERT(first.residual() < 1e-9);
}

// Two joints at the same place: G is singular.
TEST(Algorithms, OneTakesTwoJointsForOneOfBoth) {
  JointedStructure twice = jointed(golden::cases("mdof_jenkins_exact").at(0));
  const auto half = friction::make_element("ren", std::vector<double>{0.004, 1.5, 75.0});
  JointedStructure once = twice;
  once.incidence = once.incidence.leftCols(1).eval();
  twice.incidence.col(1) = twice.incidence.col(0);
  twice.laws = {half->clone(), half->clone()};
  once.laws = {friction::make_element("ren", std::vector<double>{0.004, 1.5, 150.0})};
  AlgorithmOne two(twice, sine(3, 0, 18.0, 19.0), 3e-3), one(once, sine(3, 0, 18.0, 19.0), 3e-3);
  for (int i = 0; i < 300; ++i) {
    two.step();
    one.step();
  }
  EXPECT_LT(difference(two.motion().x, one.motion().x), 1e-9);
}

TEST(Algorithms, CharacterMatrixAndBoundedInstabilityAreTheThesiss) {
  for_each_golden("thesis_18dof", [](const json& one) {
    JointedStructure structure = jointed(one);
    structure.laws = {golden::element(one.at("joint_types").at("A")), golden::element(one.at("joint_types").at("A"))};
    for (const json& row : one.at("character_matrix_A")) {
      const VectorXd k_r = VectorXd::Constant(2, row.at("kr").get<double>());
      const double radius =
          spectral_radius(character_matrix(structure, row.at("delta"), 1.0 / 3.0, k_r, structure.initial_stiffness()));
      EXPECT_NEAR(radius / row.at("largest_eigenvalue").get<double>(), 1.0, 1e-8);
    }
    structure.laws = {golden::element(one.at("joint_types").at("B")), golden::element(one.at("joint_types").at("B"))};
    for (const json& row : one.at("bounded_instability_B")) {
      const ForceHistory force = sine(18, 4, row.at("p"), 20.0 * std::numbers::pi);
      const auto largest = [&](double k_r, double delta, int steps) {
        AlgorithmTwo two(structure, force, delta, {.reference_stiffness = VectorXd::Constant(2, k_r)});
        EXPECT_EQ(two.too_soft().size(), k_r < 1e6 ? 2U : 0U);
        double most = 0.0;
        for (int i = 0; i < steps; ++i) {
          two.step();
          most = std::max(most, std::abs(two.motion().x[4]));
        }
        return most;
      };
      EXPECT_NEAR(largest(0.0, 3e-3, 100) / row.at("kr_0").get<double>(), 1.0, 1e-7);
      EXPECT_NEAR(largest(1e6, 3e-3, 100) / row.at("kr_1e+06").get<double>(), 1.0, 1e-7);
      EXPECT_NEAR(largest(0.0, 1e-4, 3000) / row.at("kr_0_delta_1e-4").get<double>(), 1.0, 1e-7);
      EXPECT_NEAR(largest(1e6, 1e-4, 3000) / row.at("kr_1e+06_delta_1e-4").get<double>(), 1.0, 1e-7);
    }
  });
}

}  // namespace
}  // namespace jointid::response

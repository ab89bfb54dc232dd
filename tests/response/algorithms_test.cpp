#include <gtest/gtest.h>

#include <numbers>

#include "golden.hpp"
#include "response/time/algorithm_one.hpp"
#include "response/time/algorithm_two.hpp"

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
      printf("solutions %g (%g) res %g growth %g\n", double(first.solutions())/run.at("steps").get<double>(), run.at("algorithm_one").at("newton_per_step").get<double>(), first.residual(), second.growth());
    }
  });
}

TEST(Algorithms, ErrWithTheSquareOfTheStep) {
  for_each_golden("algorithms", [](const json& one) {
    SCOPED_TRACE(one.at("id").get<std::string>());
    const JointedStructure structure = jointed(one);
    const ForceHistory force = sine(3, 0, one.at("p"), one.at("omega"));
    for (const json& row : one.at("errors_by_halving")) {
      const double delta = row[0];
      const int steps = static_cast<int>(std::lround(0.826735 / delta));
      AlgorithmOne first(structure, force, delta);
      AlgorithmTwo second(structure, force, delta), from_rest(structure, force, delta, {.starts_by_algorithm_one = false});
      ExactMarch exact(structure, force);
      MatrixXd errors(3, 5);
      MatrixXd x(3,5);
      const MatrixXd a = fifths(first, steps).first, b = fifths(second, steps).first, c = fifths(from_rest, steps).first;
      for (int i = 0; i < 5; ++i) { exact.march(delta * steps / 5 * (i + 1)); x.col(i) = exact.motion().x; }
      printf("%g: %g (%g) %g (%g) %g (%g)\n", delta, difference(a, x), row[1].get<double>(), difference(b, x), row[2].get<double>(), difference(c, x), row[3].get<double>());
    }
  });
}

TEST(Algorithms, CharacterMatrixAndBoundedInstabilityAreTheThesiss) {
  for_each_golden("thesis_18dof", [](const json& one) {
    JointedStructure structure = jointed(one);
    structure.laws = {law(one.at("joint_types").at("A")), law(one.at("joint_types").at("A"))};
    for (const json& row : one.at("character_matrix_A")) {
      const VectorXd k_r = VectorXd::Constant(2, row.at("kr").get<double>());
      const double radius = spectral_radius(character_matrix(structure, row.at("delta"), 1.0 / 3.0, k_r, structure.initial_stiffness()));
      EXPECT_NEAR(radius / row.at("largest_eigenvalue").get<double>(), 1.0, 1e-8);
    }
    structure.laws = {law(one.at("joint_types").at("B")), law(one.at("joint_types").at("B"))};
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

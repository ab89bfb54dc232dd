#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "response/identify/law_fit.hpp"
#include "response/identify/lifted_state.hpp"
#include "response/identify/response_residuals.hpp"
#include "tests/response/measured_masses.hpp"

namespace jointid::response {
namespace {

/// Laws without kinks, whose derivatives differences find to their digits.
const std::vector<Joint> smooth = {{.name = "a", .friction = law("ren", {0.004, 1.5, 150.0})},
                                   {.name = "b", .friction = law("shoukry", {0.6, 120.0}), .stiffness = 20.0, .damping = 0.1}};

/// Of order 6.
Eigen::VectorXd difference(const std::function<Eigen::VectorXd(double)>& of, double h) {
  return (45.0 * (of(h) - of(-h)) - 9.0 * (of(2.0 * h) - of(-2.0 * h)) + (of(3.0 * h) - of(-3.0 * h))) / (60.0 * h);
}

TEST(Jacobian, IsThatOfDifferencesToEightDigits) {
  const Structure structure = masses(2);
  const auto states = measure(structure, smooth, {0.5, 3.0}, {18.4, 20.8});
  ASSERT_FALSE(states.empty());
  const LawUnknowns unknowns(smooth);
  const ResponseResiduals residuals(structure, states, unknowns, {1, 3, 5});
  const auto value = residuals.evaluate(unknowns.start());
  ASSERT_TRUE(value);
  for (Eigen::Index i = 0; i < unknowns.size(); ++i) {
    const auto residual = [&](double step) -> Eigen::VectorXd {
      return residuals.evaluate(unknowns.start() + step * Eigen::VectorXd::Unit(unknowns.size(), i), value->states)
          ->linearised.residual;
    };
    const Eigen::VectorXd column = value->linearised.jacobian.col(i);
    EXPECT_LT((difference(residual, 2e-3) - column).cwiseAbs().maxCoeff(), 1e-8 * column.cwiseAbs().maxCoeff()) << i;
  }
}

/// A state whose force is known to 1 %, and the same with the force off by so many of its deviations, in Re and Im.
MeasuredState with_force(MeasuredState state, double real, double imaginary) {
  state.force_deviation = Eigen::MatrixXd::Constant(1, 1, 0.01 * std::abs(state.force.amplitudes(0, 0)));
  state.force.amplitudes(0, 0) += state.force_deviation(0, 0) * Complex(real, imaginary);
  return state;
}

TEST(ForceErrors, MoveResponsesAsDifferencesSay) {
  const Structure structure = masses(2);
  const auto states = measure(structure, smooth, {3.0}, {19.6});
  ASSERT_FALSE(states.empty());
  const std::vector<JointForce> forces = joint_forces(smooth);
  const MeasuredState state = with_force(states[0], 0.0, 0.0);
  const StateModel model(structure, state, {1, 3, 5});
  const StatePrediction prediction = model.predict(forces, {});
  ASSERT_TRUE(prediction.solution.converged);
  const Eigen::MatrixXd columns = ReceptanceResponse(model, forces, prediction).by_forces(1);
  ASSERT_EQ(columns.cols(), 2);
  for (int part = 0; part < 2; ++part) {
    const auto response = [&](double step) -> Eigen::VectorXd {
      const StateModel moved(structure, with_force(states[0], part == 0 ? step : 0.0, part == 1 ? step : 0.0), {1, 3, 5});
      return in_deviations(state, moved.predict(forces, {}, &prediction.solution).response);
    };
    EXPECT_LT((difference(response, 0.05) - columns.col(part)).cwiseAbs().maxCoeff(), 1e-7 * columns.cwiseAbs().maxCoeff())
        << part;
  }
}

TEST(ForceErrors, MoveLiftedRowsAsDifferencesSay) {
  const Structure structure = masses(2);
  const auto states = measure(structure, smooth, {3.0}, {19.6});
  ASSERT_FALSE(states.empty());
  const std::vector<JointForce> forces = joint_forces(smooth);
  const StateModel model(structure, with_force(states[0], 0.0, 0.0), {1, 3, 5});
  const Eigen::MatrixXcd force = model.predict(forces, {}).solution.joint_force;
  const Eigen::VectorXd tolerance = Eigen::Vector2d(0.1, 0.2);
  const Eigen::MatrixXd columns = LiftedState(model, forces, force, tolerance, true).by_forces(1);
  for (int part = 0; part < 2; ++part) {
    const auto residual = [&](double step) -> Eigen::VectorXd {
      const StateModel moved(structure, with_force(states[0], part == 0 ? step : 0.0, part == 1 ? step : 0.0), {1, 3, 5});
      return LiftedState(moved, forces, force, tolerance, false).residual();
    };
    EXPECT_LT((difference(residual, 0.05) - columns.col(part)).cwiseAbs().maxCoeff(), 1e-7 * columns.cwiseAbs().maxCoeff())
        << part;
  }
}

}  // namespace
}  // namespace jointid::response

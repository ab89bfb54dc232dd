#include <gmock/gmock.h>

#include <cmath>

#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/model/explicit_line.hpp"
#include "ident/likelihood/model/line_start.hpp"
#include "tests/ident/hammer_sets.hpp"
#include "study/recorded_noise.hpp"
#include "solver_case.hpp"

namespace jointid::ident {
namespace {

struct Named {
  const char* problem;
  std::uint64_t seed;
};

void PrintTo(const Named& named, std::ostream* out) { *out << named.problem << " seed " << named.seed; }

class Bundle : public testing::TestWithParam<Named> {};

TEST_P(Bundle, OfCeresIsTheEstimateOfTheOwnEngine) {
  const auto [name, seed] = GetParam();
  const SolverCase example(name, 0.01);
  const Solution own = example.solve("auto", seed, true), ceres = example.solve("ceres", seed, true);
  EXPECT_EQ(own.used.solver, "gauss-helmert");
  EXPECT_EQ(ceres.used.solver, "ceres");
  EXPECT_EQ(own.status, Status::ok);
  EXPECT_EQ(ceres.status, Status::ok);
  EXPECT_LT(distance(own, ceres), 1e-4);
  EXPECT_NEAR(ceres.fit.chi_square->value / own.fit.chi_square->value, 1.0, 1e-8);
  for (std::size_t i = 0; i < own.unknowns.size(); ++i) {
    EXPECT_NEAR(*ceres.unknowns[i].std_error / *own.unknowns[i].std_error, 1.0, 1e-4);
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, Bundle,
                         testing::Values(Named{"A1", 1}, Named{"A1", 2}, Named{"A1", 3}, Named{"B", 1}, Named{"B", 2}, Named{"B", 3},
                                         Named{"C2", 1}, Named{"C2", 2}, Named{"C2", 3}, Named{"E3", 1}, Named{"E3", 2},
                                         Named{"E3", 3}, Named{"G1", 1}));

/// From a start 4.7 times too stiff, where few lines fit at first.
TEST(Bundle, OfCeresIsThatEstimateWithNoSensorAtTheJointToo) {
  SolverCase example("H4", 0.01);
  example.scene.identify.equations = {Equation::nn};
  example.scene.frequency.step_hz = 20.0;
  const Solution own = example.solve("auto", 1, true), ceres = example.solve("ceres", 1, true);
  ASSERT_EQ(ceres.status, Status::ok);
  EXPECT_LT(distance(own, ceres), 0.01);
  EXPECT_NEAR(ceres.fit.chi_square->value / own.fit.chi_square->value, 1.0, 1e-5);
}

TEST(Bundle, OfCeresTakesVariancesAtEstimatedValuesToo) {
  const SolverCase example("A1", 0.05);
  const Solution own = example.solve("auto", 4, false), ceres = example.solve("ceres", 4, false);
  EXPECT_LT(distance(own, ceres), 0.02);
  EXPECT_NEAR(ceres.fit.chi_square->value / own.fit.chi_square->value, 1.0, 1e-3);
}

/// Errors that responses to one blow share, drawn and told.
TEST(Bundle, OfCeresIsThatEstimateWithCovariancesToo) {
  SolverCase example("A1", 0.01);
  example.scene.noise.reset();
  problems::Measurement data = with_hammer_noise(example.problem);
  std::uint64_t number = 0;
  const auto pollute = [&number](frf::FrfSet& set) { study::RecordedNoise(frf::whole(set)).pollute(set, {3, 0, number++}); };
  for (frf::FrfSet& set : data.substructures) pollute(set);
  pollute(data.assembly);
  const auto solved = [&](const char* solver) {
    example.scene.identify.solver = parse_solver(solver);
    return solve(*problems::plan(example.scene, data), {.threads = 1, .progress = {}, .interrupted = {}, .detail = Detail::estimates});
  };
  const Solution own = solved("auto"), ceres = solved("ceres");
  ASSERT_EQ(own.status, Status::ok);
  EXPECT_LT(distance(own, ceres), 1e-4);
  EXPECT_NEAR(ceres.fit.chi_square->value / own.fit.chi_square->value, 1.0, 1e-8);
  EXPECT_NEAR(own.fit.chi_square->value / own.fit.chi_square->degrees_of_freedom, 1.0, 0.15);
  for (std::size_t i = 0; i < own.unknowns.size(); ++i) {
    EXPECT_NEAR(*ceres.unknowns[i].std_error / *own.unknowns[i].std_error, 1.0, 1e-4);
  }
  for (frf::FrfSet* set : {&data.substructures[0], &data.substructures[1], &data.assembly}) set->covariance.clear();
  EXPECT_GT(distance(own, solved("auto")), 1.0);
}

/// The first line of a problem, at FRFs near the measured ones.
struct OneLine {
  std::unique_ptr<Plan> plan;
  std::vector<double> theta, u;
  ExplicitLine line;

  static ExplicitLine make(Plan& plan) {
    Observations& observations = *likelihood_plan(plan)->observations;
    observations.read(plan.lines, [](std::size_t) {});
    const LineData& data = observations.lines().front();
    const JointImpedance joint = joint_at(plan.restriction, *plan.columns, plan.omega0, data.omega);
    ExplicitLine out(observations.layout(), data, joint);
    const LineState start = measured_start(observations.layout(), data);
    out.set_centre(start.sub_jn, start.sub_jj);
    return out;
  }

  explicit OneLine(const SolverCase& example) : plan(example.plan("ceres", 1, true)), line(make(*plan)) {
    const std::vector<double> truth = example.truth();
    for (std::size_t i = 0; i < truth.size(); ++i) theta.push_back(1.1 * truth[i] / plan->unscale(i));
    for (std::size_t i = 0; i < line.own(); ++i) u.push_back(std::sin(static_cast<double>(i)));
  }

  Eigen::VectorXd residuals() const {
    Eigen::VectorXd out(static_cast<Eigen::Index>(line.residuals()));
    line.evaluate(theta, u.data(), out.data(), nullptr, nullptr);
    return out;
  }

  /// Central difference by one of theta or u.
  Eigen::VectorXd difference(double& parameter, double step) {
    const double middle = parameter;
    parameter = middle + step;
    const Eigen::VectorXd above = residuals();
    parameter = middle - step;
    const Eigen::VectorXd below = residuals();
    parameter = middle;
    return (above - below) / (2.0 * step);
  }
};

void expect_columns_as_differences(const SolverCase& example) {
  OneLine at(example);
  RowMatrixXd by_theta, by_own;
  Eigen::VectorXd residuals = at.residuals();
  at.line.evaluate(at.theta, at.u.data(), residuals.data(), &by_theta, &by_own);
  for (std::size_t i = 0; i < at.theta.size(); ++i) {
    const Eigen::VectorXd exact = by_theta.col(static_cast<Eigen::Index>(i));
    const double step = 1e-5 * (std::abs(at.theta[i]) > 0.0 ? std::abs(at.theta[i]) : 1.0 / exact.norm());
    EXPECT_LT((at.difference(at.theta[i], step) - exact).norm(), 1e-5 * exact.norm()) << "unknown " << i;
  }
  for (std::size_t i = 0; i < at.u.size(); ++i) {
    const Eigen::VectorXd exact = by_own.col(static_cast<Eigen::Index>(i));
    EXPECT_LT((at.difference(at.u[i], 1e-4) - exact).norm(), 1e-5 * exact.norm()) << "FRF " << i;
  }
}

TEST(ExplicitLine, DerivativesAreThoseOfDifferences) {
  for (const char* name : {"A1", "B", "C2"}) expect_columns_as_differences(SolverCase(name, 0.01));
}

TEST(ExplicitLine, DerivativesOfAMeasuredJointBlockToo) {
  SolverCase example("A1", 0.01);
  example.scene.identify.equations = {Equation::nn, Equation::nj, Equation::jj};
  expect_columns_as_differences(example);
}

TEST(LineStart, FromExactDataIsExactEitherWay) {
  SolverCase example("A1", 0.01);
  auto& noise = std::get<frf::NoiseModel>(example.problem.noise);
  noise.level = 0.0;
  const auto plan = example.plan("ceres", 1, true);
  Observations& observations = *likelihood_plan(*plan)->observations;
  observations.read(plan->lines, [](std::size_t) {});
  std::vector<double> theta = example.truth();
  for (std::size_t i = 0; i < theta.size(); ++i) theta[i] /= plan->unscale(i);
  for (const LineData& data : observations.lines()) {
    const JointImpedance joint = joint_at(plan->restriction, *plan->columns, plan->omega0, data.omega);
    const LineState measured = measured_start(observations.layout(), data);
    const LineState found = lifted_start(observations.layout(), data, joint.at(theta));
    EXPECT_LT((found.sub_jn - measured.sub_jn).norm(), 1e-8 * measured.sub_jn.norm());
    EXPECT_LT((found.sub_jj - measured.sub_jj).norm(), 1e-8 * measured.sub_jj.norm());
  }
}

}  // namespace
}  // namespace jointid::ident

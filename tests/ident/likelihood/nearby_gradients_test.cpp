// What godambe_information() asks first, from factors that another pass over the lines has.
#include <gtest/gtest.h>

#include "base/eigen.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/findings/bound_of.hpp"
#include "solver_case.hpp"

namespace jointid::ident {
namespace {

double difference(const Eigen::MatrixXd& one, const Eigen::MatrixXd& other) { return (one - other).norm() / other.norm(); }

struct Case {
  std::unique_ptr<Plan> plan = SolverCase("A1", 0.05).plan("gauss-helmert", 1, true);
  Control control;
  std::vector<double> theta;

  Case() {
    control.threads = 1;
    control.detail = Detail::estimates;
    const Solution solution = ident::solve(*plan, control);
    for (std::size_t c = 0; c < solution.unknowns.size(); ++c) theta.push_back(solution.unknowns[c].value / plan->unscale(c));
  }
};

TEST(NearbyGradients, AreThoseThatAreWorkedOutOtherwise) {
  const Case sample;
  LinearisedLikelihood there = make_estimator(*sample.plan, sample.control).at(sample.theta);
  LinearisedLikelihood::NearbyGradients begun = there.begin_godambe();
  ASSERT_EQ(begun.offsets.size(), 6U);
  const Observations& observations = *likelihood_plan(*sample.plan)->observations;
  LineModel model(observations.layout());
  for (std::size_t i = 0; i < sample.plan->lines.size(); i += 2) {  // every other line
    const ComplexMatrix z = there.impedance_of(i, sample.theta);
    model.linearise(observations.lines()[i], there.line_at(i).joint, z, there.state_of(i), true);
    ASSERT_TRUE(model.reduce(0.0, false));
    there.take_nearby(i, model, begun);
    EXPECT_EQ(begun.of_lines[i].cols(), 6);
  }
  EXPECT_LT(difference(there.godambe_information(begun), there.godambe_information()), 1e-9);
}

TEST(NearbyGradients, AreTakenWhereTheyAreThoseThatAreAskedFor) {
  const Case sample;
  LinearisedLikelihood there = make_estimator(*sample.plan, sample.control).at(sample.theta);
  LinearisedLikelihood::NearbyGradients of_information = there.begin_godambe(), of_none = of_information;
  for (std::size_t i = 0; i < of_none.of_lines.size(); ++i) {
    const ReducedLine& reduced = there.line_at(i).reduced;
    of_none.of_lines[i] = of_information.of_lines[i] = Eigen::MatrixXd::Zero(reduced.information.rows(), 6);
    for (Eigen::Index k = 0; k < 6; ++k) {
      const Eigen::VectorXd& offset = of_none.offsets[static_cast<std::size_t>(k)];
      of_information.of_lines[i].col(k) = -reduced.information * offset(there.line_at(i).columns);
    }
  }
  EXPECT_EQ(there.godambe_information(of_information), there.fit.information);
  EXPECT_GT(difference(there.godambe_information(of_none), there.fit.information), 1e-4);
  const Eigen::MatrixXd expected = there.godambe_information();
  for (auto* each : {&of_information, &of_none}) {
    each->offsets.front()[0] *= 1.001;
    EXPECT_EQ(there.godambe_information(*each), expected);
  }
}

}  // namespace
}  // namespace jointid::ident

// Some of the lines first, and all from where these end.
#include <gtest/gtest.h>

#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/findings/bound_of.hpp"
#include "ident/likelihood/fit/joint_iteration.hpp"
#include "solver_case.hpp"

namespace jointid::ident {
namespace {

struct Lines {
  std::unique_ptr<Plan> plan = SolverCase("A1", 0.02).plan("gauss-helmert", 1, true);
  PenalisedLines all = take_all();
  StepMemory memory;
  SecondOpinion opinion;
  FitWatcher watch = [](std::size_t) {};
  FitListener nobody;

  PenalisedLines take_all() const {
    Control control;
    control.threads = 1;
    read_observations(*plan, control);
    return {.lines = FittedLines(*likelihood_plan(*plan)->observations, plan->restriction, *plan->columns, plan->omega0, 1),
            .priors = {},
            .unknowns = plan->columns->size(),
            .joint_unknowns = plan->columns->size()};
  }

  JointIteration iteration() { return {all, memory, opinion, watch, nobody}; }
};

std::vector<double> truth(const Plan& plan) {
  std::vector<double> out = SolverCase("A1", 0.02).truth();
  for (std::size_t c = 0; c < out.size(); ++c) out[c] /= plan.unscale(c);
  return out;
}

double distance(const LikelihoodFit& one, const LikelihoodFit& other) {
  Eigen::VectorXd apart(static_cast<Eigen::Index>(one.theta.size()));
  for (std::size_t c = 0; c < one.theta.size(); ++c) apart[static_cast<Eigen::Index>(c)] = one.theta[c] - other.theta[c];
  return norm_of(apart, other.information);
}

TEST(SomeLinesFirst, EveryEighthIsUsed) {
  const Lines sample;
  const FittedLines some = sample.all.lines.spread(8);
  EXPECT_EQ(sample.all.lines.used(), 31U);
  EXPECT_EQ(some.used(), 4U);
  EXPECT_GT(some[8].redundancy, 0.0);
  EXPECT_EQ(some[9].redundancy, 0.0);
  EXPECT_EQ(some[8].columns, sample.all.lines[8].columns);
}

TEST(SomeLinesFirst, AllEndWhereTheyDoFromTheStart) {
  Lines sample;
  JointIteration whole = sample.iteration();
  LikelihoodFit fit = whole.begin(truth(*sample.plan), false);
  whole.run(fit, nullptr);
  ASSERT_TRUE(fit.converged);
  LikelihoodFit some;
  {
    PenalisedLines few{sample.all.lines.spread(3), {}, sample.all.unknowns, sample.all.joint_unknowns};
    StepMemory memory;
    JointIteration iteration(few, memory, sample.opinion, sample.watch, sample.nobody);
    some = iteration.begin(truth(*sample.plan), false);
    ASSERT_TRUE(iteration.approach(some));
  }
  EXPECT_GT(distance(some, fit), 1.0);
  JointIteration near = sample.iteration();
  LikelihoodFit ended = near.begin(some.theta, false);
  near.run_near(ended, nullptr);
  EXPECT_TRUE(ended.converged);
  EXPECT_LT(distance(ended, fit), 1e-3);
  EXPECT_NEAR(ended.loss, fit.loss, 1e-6 * fit.loss);
}

TEST(SomeLinesFirst, FrfsOfALineEndAtTheirMinimumFromWhereTheyWereMeasured) {
  Lines sample;
  const std::vector<double> theta = truth(*sample.plan);
  sample.all.lines.begin(theta);
  sample.all.lines.settle_measured(theta);
  std::vector<double> costs;
  for (const FittedLine& line : sample.all.lines.snapshot()) costs.push_back(line.cost);
  sample.all.lines.relax(theta);
  for (std::size_t i = 0; i < costs.size(); ++i) EXPECT_NEAR(costs[i], sample.all.lines[i].cost, 1e-4 * costs[i]) << i;
}

}  // namespace
}  // namespace jointid::ident

#include <gtest/gtest.h>

#include <cmath>

#include "ident/likelihood/findings/bootstrap.hpp"
#include "tests/ident/likelihood_case.hpp"

namespace jointid::ident {
namespace {

Solution bootstrapped(LikelihoodCase of, std::size_t threads, std::uint64_t seed = 1) {
  of.scene.identify.bootstrap = 100;
  of.scene.identify.bootstrap_seed = seed;
  return solve(*of.polluted(), {.threads = threads, .progress = {}, .interrupted = {}, .detail = Detail::full});
}

TEST(Bootstrap, AgreesWithTheBoundWhereTheProblemIsLinear) {
  const LikelihoodCase c1("C1", 0.001);
  const Solution bound = solve(*c1.polluted()), boot = bootstrapped(c1, 0);
  EXPECT_EQ(boot.intervals, IntervalKind::bootstrap);
  for (std::size_t i = 0; i < bound.unknowns.size(); ++i) {
    EXPECT_EQ(boot.unknowns[i].value, bound.unknowns[i].value);
    EXPECT_NEAR(*boot.unknowns[i].std_error / *bound.unknowns[i].std_error, 1.0, 0.3) << i;
    const auto [low, high] = *boot.unknowns[i].ci95;
    EXPECT_LT(low, boot.unknowns[i].value);
    EXPECT_GT(high, boot.unknowns[i].value);
  }
}

TEST(Bootstrap, DoesNotDependOnTheThreads) {
  const LikelihoodCase e2("E2", 0.01);
  const Solution one = bootstrapped(e2, 1), two = bootstrapped(e2, 2), other = bootstrapped(e2, 2, 2);
  for (std::size_t i = 0; i < one.unknowns.size(); ++i) {
    EXPECT_EQ(*one.unknowns[i].ci95, *two.unknowns[i].ci95);
    EXPECT_NE(*one.unknowns[i].ci95, *other.unknowns[i].ci95);
  }
}

TEST(Bootstrap, StudentisedIntervalsOfNormalReplicates) {
  // θ* = 5 + z with σ* = 1 for quantiles z of the normal distribution: the interval is that of the normal distribution.
  std::vector<Replicate> replicates;
  for (int i = -1000; i <= 1000; ++i) {
    const double z = 2.5 * std::sinh(0.001 * i);
    replicates.push_back({{5.0 + z}, {1.0}, true});
  }
  replicates.push_back({{1e9}, {1.0}, false});
  const BootstrapError error = bootstrap_error(replicates, 0, 5.0, 2.0);
  const double quantile = 2.5 * std::sinh(0.95);
  EXPECT_NEAR(error.ci95[0], 5.0 - 2.0 * quantile, 1e-9);
  EXPECT_NEAR(error.ci95[1], 5.0 + 2.0 * quantile, 1e-9);
}

}  // namespace
}  // namespace jointid::ident

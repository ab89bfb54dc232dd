#include <gmock/gmock.h>

#include <cmath>

#include "base/error.hpp"
#include "tests/ident/likelihood_case.hpp"
#include "tasks/bound.hpp"

namespace jointid::ident {
namespace {

using ::testing::HasSubstr;

std::string error_of(const LikelihoodCase& of) {
  try {
    of.clean();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Priors, ANarrowPriorFixesAnUnknown) {
  LikelihoodCase c1("C1");
  c1.scene.identify.priors = {{"K(1,1)", 7000.0, 1e-3}};
  const Solution solution = solve(*c1.polluted());
  EXPECT_NEAR(solution.unknowns[0].value, 7000.0, 0.01);
  EXPECT_NEAR(*solution.unknowns[0].std_error, 1e-3, 1e-5);
}

TEST(Priors, AWidePriorChangesNothing) {
  LikelihoodCase c2("C2", 0.01);
  const Solution before = solve(*c2.polluted());
  c2.scene.identify.priors = {{"K(1,1)", 0.0, 1e12}};
  const Solution after = solve(*c2.polluted());
  for (std::size_t i = 0; i < before.unknowns.size(); ++i) {
    EXPECT_NEAR(after.unknowns[i].value, before.unknowns[i].value, 0.02 * *before.unknowns[i].std_error);
  }
  EXPECT_NEAR(after.fit.chi_square->degrees_of_freedom, before.fit.chi_square->degrees_of_freedom + 1.0, 1e-9);
}

TEST(Priors, AnIndependentPriorAddsItsInformation) {
  // With σ equal to the bound b of an unknown, its error must become b/√2: 1/b² + 1/σ² of information on it.
  LikelihoodCase a1("A1", 0.01);
  std::vector<double> truth;
  for (const problems::ExactUnknown& unknown : a1.problem.unknowns) truth.push_back(unknown.value);
  const double bound = tasks::cramer_rao_bound(*a1.clean(), truth, {})[0];
  a1.scene.identify.priors = {{"K(1,1)", truth[0], bound}};
  EXPECT_NEAR(tasks::cramer_rao_bound(*a1.clean(), truth, {})[0], bound / std::sqrt(2.0), 1e-6 * bound);
}

TEST(Priors, APriorThatContradictsTheDataRaisesChiSquare) {
  LikelihoodCase c2("C2", 0.01);
  const Solution before = solve(*c2.polluted());
  const double error = *before.unknowns[0].std_error;
  c2.scene.identify.priors = {{"K(1,1)", before.unknowns[0].value + 10.0 * error, error}};
  const Solution after = solve(*c2.polluted());
  // Two measurements of equal variance 10σ apart meet in the middle: 2·(5σ)²/σ².
  EXPECT_NEAR(after.fit.chi_square->value - before.fit.chi_square->value, 50.0, 5.0);
}

TEST(Priors, UnknownNamesAndOtherMethodsAreErrors) {
  LikelihoodCase c1("C1");
  c1.scene.identify.priors = {{"K(1,9)", 7000.0, 1.0}};
  EXPECT_THAT(error_of(c1), HasSubstr("[identify] priors: the joint has no unknown K(1,9)"));
  EXPECT_THAT(error_of(c1), HasSubstr("did you mean K(1,1)?"));
  c1.scene.identify.method = Method::one;
  EXPECT_THAT(error_of(c1), HasSubstr("method \"one\" has no use for priors"));
  c1.scene.identify.priors.clear();
  c1.scene.identify.bootstrap = 200;
  EXPECT_THAT(error_of(c1), HasSubstr("method \"one\" has no bootstrap"));
}

}  // namespace
}  // namespace jointid::ident

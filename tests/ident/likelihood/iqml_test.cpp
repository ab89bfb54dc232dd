#include <gmock/gmock.h>

#include <cmath>

#include "solver_case.hpp"
#include "tasks/bound.hpp"

namespace jointid::ident {
namespace {

/// Root mean square over unknowns and seeds of error / bound.
double error_over_bound(const SolverCase& example, const std::string& solver, std::uint64_t seeds) {
  const std::vector<double> truth = example.truth();
  const auto exact = problems::plan(example.scene, {example.problem.substructures, example.problem.assembly});
  const std::vector<double> bound = tasks::cramer_rao_bound(*exact, truth, Control());
  double squares = 0.0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const Solution found = example.solve(solver, seed, false);
    EXPECT_EQ(found.status, Status::ok);
    for (std::size_t i = 0; i < truth.size(); ++i) squares += std::pow((found.unknowns[i].value - truth[i]) / bound[i], 2);
  }
  return std::sqrt(squares / static_cast<double>(seeds * truth.size()));
}

TEST(Iqml, IsNearTheBoundForSmallErrors) {
  EXPECT_LT(error_over_bound(SolverCase("A1", 0.001), "iqml", 20), 1.3);
}

TEST(Iqml, SaysWhatItDid) {
  const Solution found = SolverCase("A1", 0.001).solve("iqml", 1, false);
  EXPECT_EQ(found.used.solver, "iqml");
  EXPECT_GT(found.fit.iterations, 1u);
  EXPECT_NEAR(found.fit.chi_square->value / found.fit.chi_square->degrees_of_freedom, 1.0, 0.2);
  EXPECT_TRUE(found.unknowns.front().std_error.has_value());
  EXPECT_GT(found.used.accumulator_bytes, 31u * 100u);
}

}  // namespace
}  // namespace jointid::ident

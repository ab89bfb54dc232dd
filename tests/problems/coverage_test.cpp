#include <gtest/gtest.h>

#include "friction/fit/fit.hpp"
#include "problems/thesis/loading_curves.hpp"

namespace jointid::problems {
namespace {

friction::Family family(const LoadingCurve& problem) {
  if (!problem.ring) return friction::family(problem.law);
  return friction::ring_family(problem.law, problem.ring->inner, problem.ring->outer);
}

/// Rows of Tables 2.1, 2.2, 2.4, 2.5 with 1 % noise.
class Coverage : public testing::TestWithParam<std::string> {};

TEST_P(Coverage, OfThe95PercentIntervalsOver200Seeds) {
  const std::size_t seeds = 200;
  std::size_t rows = 0;
  for (const LoadingCurve& problem : loading_curves()) {
    if (problem.name.find(GetParam()) != 0) continue;
    ++rows;
    std::size_t inside = 0, limit_inside = 0;
    const double limit = element_of(problem)->limit();
    const auto holds = [](const friction::FittedValue& value, double truth) {
      return value.ci95 && (*value.ci95)[0] <= truth && truth <= (*value.ci95)[1];
    };
    for (std::size_t seed = 1; seed <= seeds; ++seed) {
      const friction::Curve curve = make_curve(problem, 100, 0.01, seed);
      const friction::Fit found = friction::fit(std::span(&curve, 1), family(problem));
      EXPECT_EQ(found.status, Status::ok) << problem.name << " seed " << seed;
      for (std::size_t i = 0; i < problem.values.size(); ++i) inside += holds(found.curves[0].parameters[i], problem.values[i]);
      limit_inside += holds(found.curves[0].limit, limit);
    }
    const double coverage = static_cast<double>(inside) / static_cast<double>(seeds * problem.values.size());
    EXPECT_GE(coverage, 0.92) << problem.name;
    EXPECT_LE(coverage, 0.97) << problem.name;
    EXPECT_GE(static_cast<double>(limit_inside) / seeds, 0.92) << problem.name;
    EXPECT_LE(static_cast<double>(limit_inside) / seeds, 0.97) << problem.name;
    std::printf("%s: %.4f, of the limit %.4f\n", problem.name.c_str(), coverage, static_cast<double>(limit_inside) / seeds);
  }
  EXPECT_GT(rows, 0u);
}

INSTANTIATE_TEST_SUITE_P(Tables, Coverage, testing::Values("table2.1", "table2.2", "table2.4", "table2.5"),
                         [](const auto& table) { return table.param.substr(5, 1) + "_" + table.param.substr(7); });

}  // namespace
}  // namespace jointid::problems

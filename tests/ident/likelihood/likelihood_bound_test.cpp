#include <gtest/gtest.h>

#include "tests/ident/likelihood_accuracy.hpp"

namespace jointid::ident {
namespace {

TEST(CramerRaoBound, IsProportionalToTheNoise) {
  LikelihoodCase a1("A1");
  const std::vector<double> small = a1.at(0.001).bound(), large = a1.at(0.01).bound();
  for (std::size_t u = 0; u < small.size(); ++u) EXPECT_NEAR(large[u], 10.0 * small[u], 1e-4 * large[u]);
}

TEST(CramerRaoBound, MoreEquationsNeverRaiseIt) {
  using enum Equation;
  std::vector<double> before;
  for (const std::vector<Equation>& equations : {std::vector{nn}, {nn, nj}, {nn, nj, jj}}) {
    const std::vector<double> now = LikelihoodCase("A1", equations).at(0.05).bound();
    for (std::size_t u = 0; u < before.size(); ++u) EXPECT_LE(now[u], before[u] * (1.0 + 1e-9));
    before = now;
  }
}

TEST(CramerRaoBound, MoreLinesNeverRaiseIt) {
  LikelihoodCase a1("A1");
  a1.at(0.05).scene.frequency.range_hz = Range{400.0, 800.0};
  const std::vector<double> few = a1.bound();
  a1.scene.frequency.range_hz = Range{400.0, 1000.0};
  const std::vector<double> all = a1.bound();
  for (std::size_t u = 0; u < few.size(); ++u) EXPECT_LE(all[u], few[u] * (1.0 + 1e-9));
}

}  // namespace
}  // namespace jointid::ident

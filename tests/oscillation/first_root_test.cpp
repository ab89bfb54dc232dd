#include "oscillation/integrate/first_root.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "base/random.hpp"

namespace jointid::oscillation {
namespace {

TEST(FirstRoot, OfRandomProductsIsTheirSmallest) {
  for (std::uint64_t trial = 0; trial < 2000; ++trial) {
    std::vector<double> c = {1.0};
    double least = 2.0;
    for (std::uint64_t k = 0; k < 8; ++k) {
      const double root = 3.0 * uniform_numbers({trial, 0, 0}, k)[0] - 1.0;
      if (root > 0.0) least = std::min(least, root);
      std::vector<double> next(c.size() + 1, 0.0);
      for (std::size_t i = 0; i < c.size(); ++i) next[i] += c[i], next[i + 1] -= c[i] / root;
      c = next;
    }
    const auto found = first_root(c, 1.0);
    if (least > 1.0) {
      EXPECT_FALSE(found) << trial;
    } else {
      ASSERT_TRUE(found) << trial;
      EXPECT_NEAR(*found, least, 1e-7) << trial;
    }
  }
}

TEST(FirstRoot, SeesTangenciesAndStarts) {
  EXPECT_NEAR(*first_root(std::vector<double>{0.25, -1.0, 1.0}, 1.0), 0.5, 1e-8);
  EXPECT_FALSE(first_root(std::vector<double>{0.25 + 1e-13, -1.0, 1.0}, 1.0));
  EXPECT_EQ(*first_root(std::vector<double>{0.0, 1.0}, 1.0), 0.0);
  EXPECT_FALSE(first_root(std::vector<double>{1.0, -0.5}, 1.9));
  EXPECT_NEAR(*first_root(std::vector<double>{1.0, -0.5}, 2.1), 2.0, 1e-15);
}

}  // namespace
}  // namespace jointid::oscillation

#include <gtest/gtest.h>

#include "counted_coupling.hpp"

namespace jointid::coupling {
namespace {

/// Symmetric and well-conditioned.
ComplexMatrix some_matrix(Index n) {
  ComplexMatrix h(n, n);
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) h(i, j) = Complex(1.0 / static_cast<double>(1 + i + j), i == j ? 2.0 : 0.1);
  }
  return h;
}

TEST(OperationCount, MtcIsBelowGrcAsInFigureFivePointFour) {
  for (const Index n : {6, 12, 24}) {
    for (Index m = 1; 2 * m <= n; ++m) {
      const CountedCoupling count = count_multiplications(some_matrix(n), m);
      EXPECT_LT(count.difference, 1e-12);
      // (5.45) of docs/formulas.md §8, and one division each: as many as rank-one steps through all that is not deleted yet.
      Index steps = m;
      for (Index i = 1; i <= m; ++i) steps += (n - i) * (n + 1 - i);
      EXPECT_EQ(static_cast<Index>(count.mtc), steps);
      // (5.46) but for the inverse, which (D) counts as 2(m−i)(m+1) + m²; Gauss–Jordan without its zeros takes m³.
      EXPECT_EQ(static_cast<Index>(count.grc), m * n * (n - m) + m * m * m);
      if (m > 1) {
        EXPECT_LT(count.mtc, count.grc) << n << " coordinates, " << m << " pairs";
      }
    }
  }
}

}  // namespace
}  // namespace jointid::coupling

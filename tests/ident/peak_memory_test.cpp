#include <gtest/gtest.h>

#include "computed_system.hpp"
#include "counted_memory.hpp"
#include "ident/identify.hpp"

namespace jointid::ident {
namespace {

/// Peak bytes that solve() needs on top of the plan.
std::size_t peak_of_solve(std::size_t lines, std::size_t threads) {
  const auto plan = computed_plan(lines);
  EXPECT_EQ(plan->cost.lines, lines);
  return peak_bytes_of([&] {
    const Solution solution = solve(*plan, {.threads = threads, .progress = {}, .interrupted = {}});
    EXPECT_EQ(solution.fit.lines, lines);
  });
}

TEST(PeakMemory, IsThatOfAChunkHoweverManyLinesThereAre) {
  // 200 lines of two systems of 40×40 FRFs are 10 MB, 10 000 are 512 MB; a chunk is at most 8 MB (and its copies).
  // Eigen's small matrices, which do not come from operator new, are not counted.
  const std::size_t few = peak_of_solve(200, 1), many = peak_of_solve(10000, 1);
  EXPECT_GT(few, 5'000'000u);
  EXPECT_LT(few, 40'000'000u);
  EXPECT_LE(static_cast<double>(many), 1.02 * static_cast<double>(few));
  // Two threads have at most three chunks in flight.
  EXPECT_LE(static_cast<double>(peak_of_solve(10000, 2)), 3.06 * static_cast<double>(few));
}

}  // namespace
}  // namespace jointid::ident

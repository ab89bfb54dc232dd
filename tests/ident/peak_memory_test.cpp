#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

#include "computed_system.hpp"
#include "ident/solve.hpp"

// Counts all bytes in use by operator new; each block is preceded by its size.
namespace {

std::atomic<std::size_t> bytes_in_use{0}, peak_bytes{0};
constexpr std::size_t head = alignof(std::max_align_t);

void* counted(std::size_t size) {
  auto* block = static_cast<char*>(std::malloc(size + head));
  if (block == nullptr) throw std::bad_alloc();
  *reinterpret_cast<std::size_t*>(block) = size;
  const std::size_t now = bytes_in_use += size;
  std::size_t peak = peak_bytes;
  while (now > peak && !peak_bytes.compare_exchange_weak(peak, now)) {
  }
  return block + head;
}

void release(void* pointer) noexcept {
  if (pointer == nullptr) return;
  char* block = static_cast<char*>(pointer) - head;
  bytes_in_use -= *reinterpret_cast<std::size_t*>(block);
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void operator delete(void* pointer) noexcept { release(pointer); }
void operator delete[](void* pointer) noexcept { release(pointer); }
void operator delete(void* pointer, std::size_t) noexcept { release(pointer); }
void operator delete[](void* pointer, std::size_t) noexcept { release(pointer); }

namespace jointid::ident {
namespace {

/// Peak bytes that solve() needs on top of the plan.
std::size_t peak_of_solve(std::size_t lines, std::size_t threads) {
  const auto plan = computed_plan(lines);
  EXPECT_EQ(plan->cost.lines, lines);
  const std::size_t before = bytes_in_use;
  peak_bytes = before;
  const Solution solution = solve(*plan, {.threads = threads, .progress = {}, .interrupted = {}});
  EXPECT_EQ(solution.fit.lines, lines);
  return peak_bytes - before;
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

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>

#include "ident/solve.hpp"
#include "memory_systems.hpp"

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

/// FRFs that are computed when they are read.
class Computed final : public frf::FrfSource {
 public:
  Computed(std::size_t lines, const Dofs& all, double seed) : seed_(seed) {
    for (std::size_t i = 1; i <= lines; ++i) header_.frequency_hz.push_back(0.1 * static_cast<double>(i));
    header_.response = header_.reference = all;
  }

 private:
  void do_read(const frf::Block& block, std::span<frf::Complex> out) override {
    std::size_t next = 0;
    for (const std::size_t line : block.lines) {
      for (const std::size_t r : block.responses) {
        for (const std::size_t c : block.references) {
          const double phase = static_cast<double>(1 + 31 * r + 17 * c + line * (r + 2 * c + 1)) * seed_;
          out[next++] = {phase - std::floor(phase), 0.1};
        }
      }
    }
  }
  void do_read_variance(const frf::Block&, std::span<frf::Complex>) override {}
  void do_read_coherence(const frf::Block&, std::span<double>) override {}

  double seed_;
};

std::unique_ptr<frf::FrfSystem> computed_system(const char* name, std::size_t lines, const Dofs& all, double seed) {
  std::vector<std::unique_ptr<frf::FrfSource>> sources;
  sources.push_back(std::make_unique<Computed>(lines, all, seed));
  return std::make_unique<frf::FrfSystem>(name, std::move(sources), frf::Composition::merged, false);
}

/// Peak bytes that solve() needs on top of the plan.
std::size_t peak_of_solve(std::size_t lines, std::size_t threads) {
  Dofs all;
  for (int node = 1; node <= 40; ++node) all.push_back({.node = node, .direction = frf::Direction::x});
  Scene scene;
  scene.joints = {joint_of({all.begin(), all.begin() + 3}, restrictions::Kind::stiffness, restrictions::Pattern::full)};
  const auto plan = make_plan(scene, computed_system("substructures", lines, all, 0.7),
                              computed_system("assembly", lines, all, 1.3));
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

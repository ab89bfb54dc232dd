#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <vector>

#include "computed_system.hpp"
#include "ident/equations/assemble.hpp"
#include "ident/equations/linear_plan.hpp"
#include "ident/identify.hpp"
#include "ident/result/chunk_pipeline.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t lines = 1000;

/// Lines of a chunk of a plan.
std::size_t chunk_of(const Plan& plan) { return chunk_lines(linear_plan(plan)->builder->entries_per_line()); }

Solution solve_with(Plan& plan, std::size_t threads) {
  return solve(plan, {.threads = threads, .progress = {}, .interrupted = {}});
}

std::vector<double> values_of(const Solution& solution) {
  std::vector<double> values;
  for (const Estimate& estimate : solution.unknowns) values.push_back(estimate.value);
  return values;
}

void expect_identical(const Solution& one, const Solution& other) {
  EXPECT_EQ(values_of(one), values_of(other));
  EXPECT_EQ(one.fit.equations_used, other.fit.equations_used);
  EXPECT_EQ(one.fit.equations_dropped, other.fit.equations_dropped);
  EXPECT_EQ(one.fit.lines, other.fit.lines);
  EXPECT_EQ(one.fit.rank, other.fit.rank);
  EXPECT_EQ(one.fit.condition, other.fit.condition);
  ASSERT_TRUE(one.fit.asm_frf_error && other.fit.asm_frf_error);
  EXPECT_EQ(*one.fit.asm_frf_error, *other.fit.asm_frf_error);
}

TEST(Threads, TheSolutionIsBitForBitTheSameForAnyNumber) {
  const auto plan = computed_plan(lines);
  ASSERT_GT(lines, 2 * chunk_of(*plan)) << "the test needs several chunks";
  const Solution alone = solve_with(*plan, 1);
  EXPECT_EQ(alone.fit.lines, lines);
  EXPECT_EQ(alone.unknowns.size(), 9u);
  for (const std::size_t threads : {2u, 3u}) expect_identical(alone, solve_with(*plan, threads));
}

/// Σ over chunks by hand: the same lines in the same order, put into one accumulator without any chunk.
Assembled assembled_at_once(Plan& plan) {
  Assembled out{minimise::Accumulator(plan.columns->size(), minimise::Reduction::orthogonal), {}, 0, {}};
  LineAssembler assembler(linear_plan(plan)->spec);
  std::vector<std::size_t> substructures, assembly;
  for (const Line& line : plan.lines) {
    substructures.push_back(line.substructures);
    assembly.push_back(line.assembly);
  }
  linear_plan(plan)->builder->read(substructures, assembly);
  minimise::LineProduct product;
  for (std::size_t i = 0; i < plan.lines.size(); ++i) {
    product.frequency_hz = plan.lines[i].frequency_hz;
    if (linear_plan(plan)->builder->line(i, product)) assembler.add(product, out.accumulator);
  }
  out.equations = assembler.count();
  out.lines = assembler.lines_used();
  return out;
}

TEST(Threads, ChunkedEstimatesAreThoseOfOneChunk) {
  const auto plan = computed_plan(lines);
  ASSERT_GT(lines, 2 * chunk_of(*plan)) << "the test needs several chunks";
  RunTime time;
  Assembled chunked = assemble(*plan, time, {.threads = 2, .progress = {}, .interrupted = {}});
  Assembled at_once = assembled_at_once(*plan);
  EXPECT_EQ(chunked.equations.used, at_once.equations.used);
  EXPECT_EQ(chunked.lines, at_once.lines);
  const std::vector<double> y = solve(*plan, chunked.accumulator).y, expected = solve(*plan, at_once.accumulator).y;
  ASSERT_EQ(y.size(), expected.size());
  double scale = 0.0;
  for (const double value : expected) scale = std::max(scale, std::abs(value));
  EXPECT_GT(scale, 0.0);
  for (std::size_t i = 0; i < y.size(); ++i) EXPECT_NEAR(y[i], expected[i], 1e-12 * scale);
}

TEST(Threads, ProgressGoesThroughBothStagesChunkByChunk) {
  for (const std::size_t threads : {1u, 3u}) {
    const auto plan = computed_plan(lines);
    std::vector<std::string> stages;
    std::vector<std::size_t> done;
    const auto progress = [&](const char* stage, std::size_t at, std::size_t total) {
      EXPECT_EQ(total, std::string(stage) == "solving" ? 0 : lines);
      if (stages.empty() || stages.back() != stage) stages.emplace_back(stage);
      if (stages.size() == 1) done.push_back(at);
    };
    solve(*plan, {.threads = threads, .progress = progress, .interrupted = {}});
    EXPECT_THAT(stages, testing::ElementsAre("assembling", "solving", "predicting"));
    std::vector<std::size_t> expected;
    for (std::size_t first = 0; first < lines; first += chunk_of(*plan)) expected.push_back(first);
    EXPECT_EQ(done, expected);
  }
}

TEST(Threads, AnInterruptedPlanCanBeSolvedAgain) {
  for (const std::size_t threads : {1u, 3u}) {
    const auto plan = computed_plan(lines), fresh = computed_plan(lines);
    // At the first chunk, in the midst of assembling, and while the assembly is predicted.
    for (const int calls : {0, 2, 5}) {
      std::atomic<int> asked = 0;
      const auto interrupted = [&] { return asked++ >= calls; };
      EXPECT_THROW(solve(*plan, {.threads = threads, .progress = {}, .interrupted = interrupted}), Interrupted);
      EXPECT_EQ(asked, calls + 1) << "work went on after the interruption";
    }
    expect_identical(solve_with(*plan, threads), solve_with(*fresh, threads));
  }
}

}  // namespace
}  // namespace jointid::ident

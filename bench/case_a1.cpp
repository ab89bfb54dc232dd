// Case A1 from FRFs in memory, one thread: jointid against the plain way, in turns, with equal answers.
// Exit code 1 when it is less than 20 times faster or the answers differ by more than 1e-9 of the largest element.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "bench/plain.hpp"
#include "ident/row_expander.hpp"
#include "ident/solve.hpp"
#include "problems/in_memory.hpp"

namespace {

using namespace jointid;

template <class Work>
double seconds(int repetitions, const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < repetitions; ++i) work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / repetitions;
}

std::vector<double> solve_fast(ident::Plan& plan) {
  ident::RunTime runtime;
  ident::Assembled system = ident::assemble(plan, runtime);
  return ident::solve(plan, system.accumulator, ident::Condition::skip).y;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

}  // namespace

int main() {
  const problems::Problem problem = problems::make("A1");
  const problems::Measurement measurement = problems::polluted(problem, 1, 0);
  const auto plan = problems::plan(problems::scene(problem), measurement);

  std::vector<double> fast, plain, fast_times, plain_times, ratios;
  for (int round = 0; round < 15; ++round) {
    plain_times.push_back(seconds(5, [&] { plain = bench::solve_plainly(measurement); }));
    fast_times.push_back(seconds(50, [&] { fast = solve_fast(*plan); }));
    ratios.push_back(plain_times.back() / fast_times.back());
  }
  double difference = 0.0;
  for (std::size_t i = 0; i < fast.size(); ++i) {
    const auto first = plain.begin() + (i < 10 ? 0 : 10);
    const double largest = std::abs(*std::max_element(first, first + 10, [](double a, double b) {
      return std::abs(a) < std::abs(b);
    }));
    difference = std::max(difference, std::abs(fast[i] - plain[i]) / largest);
  }
  fmt::print("case A1, 31 lines, nn + nj, WA, 5 % noise, one thread, median of 15 rounds in turns\n");
  fmt::print("  all equations stacked, one dense QR  {:8.3f} ms\n", 1e3 * median(plain_times));
  fmt::print("  jointid                              {:8.3f} ms\n", 1e3 * median(fast_times));
  fmt::print("  ratio                                {:8.1f}   (at least 20)\n", median(ratios));
  fmt::print("  largest difference of the answers    {:8.1e}   (of the matrix's largest element, at most 1e-9)\n", difference);
  return median(ratios) >= 20.0 && difference <= 1e-9 ? 0 : 1;
}

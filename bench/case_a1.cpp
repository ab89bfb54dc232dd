// Case A1 from FRFs in memory, one thread: jointid against the plain way, in turns, with equal answers.
// Exit code 1 when it is less than 20 times faster or the answers differ by more than 1e-9 of the largest element.
#include <fmt/format.h>

#include <chrono>

#include "bench/measure.hpp"
#include "bench/plain.hpp"
#include "ident/equations/assemble.hpp"
#include "ident/equations/row_expander.hpp"
#include "ident/identify.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"

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

}  // namespace

int main() {
  const problems::Problem problem = problems::make("A1");
  const problems::Measurement measurement = problems::polluted(problem, 1, 0);
  const auto plan = problems::plan(problems::scene(problem), measurement);

  std::vector<double> fast, plain, fast_times, pivoted_times, unpivoted_times, ratios, unpivoted_ratios;
  for (int round = 0; round < 15; ++round) {
    unpivoted_times.push_back(seconds(5, [&] { plain = bench::solve_plainly(measurement, bench::DenseQr::unpivoted); }));
    pivoted_times.push_back(seconds(5, [&] { plain = bench::solve_plainly(measurement, bench::DenseQr::pivoted); }));
    fast_times.push_back(seconds(50, [&] { fast = solve_fast(*plan); }));
    ratios.push_back(pivoted_times.back() / fast_times.back());
    unpivoted_ratios.push_back(unpivoted_times.back() / fast_times.back());
  }
  const double difference = bench::largest_difference_of_case_a1(fast, plain);
  fmt::print("case A1, 31 lines, nn + nj, WA, 5 % noise, one thread, median of 15 rounds in turns\n");
  fmt::print("  all equations stacked, one dense QR with column pivoting  {:8.3f} ms\n", 1e3 * bench::median(pivoted_times));
  fmt::print("  the same without pivoting (tells no rank)                 {:8.3f} ms\n", 1e3 * bench::median(unpivoted_times));
  fmt::print("  jointid (tells the rank)                                  {:8.3f} ms\n", 1e3 * bench::median(fast_times));
  fmt::print("  ratio                                                     {:8.1f}     at least 20; without pivoting {:.1f}\n",
             bench::median(ratios), bench::median(unpivoted_ratios));
  fmt::print("  largest difference of the answers                         {:8.1e}     of the largest element, at most 1e-9\n",
             difference);
  return bench::median(ratios) >= 20.0 && difference <= 1e-9 ? 0 : 1;
}

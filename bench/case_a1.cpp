// Case A1 from FRFs in memory, one thread: jointid against the plain way, in turns, with equal answers.
// Promised: it is 20 times faster, and the answers agree to 1e-9 of the largest element.
#include <fmt/core.h>

#include "bench/bench.hpp"
#include "bench/plain.hpp"
#include "ident/equations/assemble.hpp"
#include "ident/equations/row_expander.hpp"
#include "ident/identify.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"

namespace {

using namespace jointid;

std::vector<double> solve_fast(ident::Plan& plan) {
  ident::RunTime runtime;
  ident::Assembled system = ident::assemble(plan, runtime);
  return ident::solve(plan, system.accumulator, minimise::Condition::skip).y;
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  const int rounds = line.quick() ? 1 : 15;
  const problems::Problem problem = problems::make("A1");
  const problems::Measurement measurement = problems::polluted(problem, 1, 0);
  const auto plan = problems::plan(problems::scene(problem), measurement);

  std::vector<double> fast, plain, fast_times, pivoted_times, unpivoted_times, ratios, unpivoted_ratios;
  for (int round = 0; round < rounds; ++round) {
    unpivoted_times.push_back(bench::seconds([&] { plain = bench::solve_plainly(measurement, bench::DenseQr::unpivoted); }, 5));
    pivoted_times.push_back(bench::seconds([&] { plain = bench::solve_plainly(measurement, bench::DenseQr::pivoted); }, 5));
    fast_times.push_back(bench::seconds([&] { fast = solve_fast(*plan); }, 50));
    ratios.push_back(pivoted_times.back() / fast_times.back());
    unpivoted_ratios.push_back(unpivoted_times.back() / fast_times.back());
  }
  const double difference = bench::largest_difference_of_case_a1(fast, plain);
  fmt::print("case A1, 31 lines, nn + nj, WA, 5 % noise, one thread, median of {} rounds in turns\n", rounds);
  fmt::print("  all equations stacked, one dense QR with column pivoting  {:8.3f} ms\n", 1e3 * median(pivoted_times));
  fmt::print("  the same without pivoting (tells no rank)                 {:8.3f} ms\n", 1e3 * median(unpivoted_times));
  fmt::print("  jointid (tells the rank)                                  {:8.3f} ms\n", 1e3 * median(fast_times));
  fmt::print("  ratio                                                     {:8.1f}     at least 20; without pivoting {:.1f}\n",
             median(ratios), median(unpivoted_ratios));
  fmt::print("  largest difference of the answers                         {:8.1e}     of the largest element, at most 1e-9\n",
             difference);
  promises.speed_at_least("times faster than one dense QR with pivoting", median(ratios), 20.0);
  promises.at_most("difference of the answers, of the largest element", difference, 1e-9);
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "", measure); }

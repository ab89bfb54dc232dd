// Solvers of the reduced system of many joints: dense QR, SPQR, CHOLMOD and LDLᵀ on the same rows of chains, frames and a star, 1 % noise.
// Prints the table of docs/many-joints.md: processor time, growth of the peak of memory, digits against a solution that is refined with
// residuals in long double. Misses its promise when SPQR is less than 10 times as fast as dense QR at 1,000 unknowns of a chain, takes more
// than 0.1 s at 5,000 or 0.5 s at 10,000, or a solver loses more digits than it may.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "bench/memory.hpp"
#include "ident/equations/assemble.hpp"
#include "ident/equations/system_pattern.hpp"
#include "minimise/linear/solve_linear.hpp"
#include "minimise/linear/sparse_normal.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/case/many_joints_problem.hpp"

namespace {

using namespace jointid;

struct Structure {
  std::string name;
  std::function<problems::ManyJoints()> make;
  bool all_elements = true;
};

problems::ManyJoints chain(std::size_t joints) { return problems::chain_of_beams({.joints = joints}); }

problems::ManyJoints frame(std::size_t nodes) {
  return problems::frame_of_beams({.columns = nodes, .rows = nodes, .legs = nodes, .spacing = 9});
}

const std::vector<Structure> all = {{"chain 200", [] { return chain(10); }},
                                    {"chain 1000", [] { return chain(50); }},
                                    {"chain 5000", [] { return chain(250); }},
                                    {"chain 10000", [] { return chain(500); }},
                                    {"frame 240", [] { return frame(4); }, false},
                                    {"frame 10x10", [] { return frame(10); }, false},
                                    {"frame 22x22", [] { return frame(22); }, false},
                                    {"star 300", [] { return problems::star_of_beams({}); }, false}};

/// In scaled unknowns; residuals in long double.
std::vector<double> refined(const minimise::StackedTriangles& stacked) {
  const auto factor = minimise::ldlt_cholesky();
  if (!factor->factorize(minimise::normal_matrix(stacked))) return {};
  const minimise::SparseEntries& a = stacked.matrix;
  std::vector<long double> y(a.columns, 0.0L);
  for (int step = 0; step < 6; ++step) {
    std::vector<long double> rows(stacked.right.begin(), stacked.right.end()), columns(a.columns, 0.0L);
    for (std::size_t e = 0; e < a.value.size(); ++e)
      rows[static_cast<std::size_t>(a.row[e])] -= static_cast<long double>(a.value[e]) * y[static_cast<std::size_t>(a.column[e])];
    for (std::size_t e = 0; e < a.value.size(); ++e)
      columns[static_cast<std::size_t>(a.column[e])] += static_cast<long double>(a.value[e]) * rows[static_cast<std::size_t>(a.row[e])];
    const std::vector<double> change = factor->solve({columns.begin(), columns.end()});
    for (std::size_t j = 0; j < y.size(); ++j) y[j] += static_cast<long double>(change[j]);
  }
  return {y.begin(), y.end()};
}

double digits_of(const std::vector<double>& y, const std::vector<double>& exact, const std::vector<double>& scale) {
  double error = 0.0, largest = 0.0;
  for (std::size_t j = 0; j < exact.size(); ++j) {
    error = std::max(error, std::abs(y[j] / scale[j] - exact[j]));
    largest = std::max(largest, std::abs(exact[j]));
  }
  return error > 0.0 ? -std::log10(error / largest) : 17.0;
}

struct Row {
  double seconds = std::nan("");
};

Row measure(const std::string& solver, minimise::Accumulator& system, const std::vector<double>& exact, const std::vector<double>& scale,
            bench::Promises& promises, double least_digits) {
  minimise::LinearSolution found;
  const auto once = [&] {
    constexpr auto skip = minimise::Condition::skip;
    found = solver == "dense"     ? minimise::solve_dense(system, skip)
            : solver == "SPQR"    ? minimise::solve_sparse(system, skip, minimise::SparseWay::qr)
            : solver == "CHOLMOD" ? minimise::solve_sparse(system, skip, minimise::SparseWay::cholmod)
                                  : minimise::solve_sparse(system, skip, minimise::SparseWay::ldlt);
  };
  const double memory = bench::growth_megabytes(once);
  bench::Times times;
  do times.add(once);
  while (times.processor.size() < 5 && bench::least(times.processor) < 0.5);
  const double digits = digits_of(found.y, exact, scale), seconds = bench::least(times.processor);
  fmt::print("  {:8} {:10.4f} s {:9.1f} MB {:6.1f} digits, condition {:.3g}\n", solver, seconds, memory, digits, found.condition);
  promises.at_least(solver + ": digits", digits, least_digits);
  promises.holds(solver + ": full rank", found.rank == system.columns());
  return {seconds};
}

void measure(const Structure& structure, bool with_dense, bench::Promises& promises) {
  const problems::Problem problem = problems::many_joints_problem(structure.make(), {structure.name, ""}, structure.all_elements);
  const auto plan = problems::plan(problems::scene(problem), problems::polluted(problem, 1, 0));
  ident::RunTime time;
  minimise::Accumulator system = ident::assemble(*plan, time).accumulator;
  system.flush();
  system.release();
  const minimise::StackedTriangles stacked(system);
  const std::vector<double> exact = refined(stacked);
  const auto pattern = ident::system_pattern(*plan, 0);
  fmt::print("{}: {} unknowns, {} parts, widest {}, {} numbers in the factor ({:.3g} of a dense one), solver auto is {}\n", structure.name,
             pattern->unknowns, pattern->supports, pattern->widest, pattern->factor_entries, pattern->share_of_dense(),
             ident::name(plan->solver));
  Row dense;
  if (with_dense) dense = measure("dense", system, exact, stacked.scale, promises, 11.0);
  Row spqr;
  if (minimise::has_spqr()) {
    spqr = measure("SPQR", system, exact, stacked.scale, promises, 11.0);
    measure("CHOLMOD", system, exact, stacked.scale, promises, 12.0);
  } else {
    promises.skip("SuiteSparse is not here");
  }
  measure("LDLT", system, exact, stacked.scale, promises, 12.0);
  if (structure.name == "chain 1000") promises.speed_at_least("dense over SPQR at 1,000", dense.seconds / spqr.seconds, 10.0);
  if (structure.name == "chain 5000") promises.speed_at_most("SPQR at 5,000, s", spqr.seconds, 0.1);
  if (structure.name == "chain 10000") promises.speed_at_most("SPQR at 10,000, s", spqr.seconds, 0.5);
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run(argc, argv, "[MOST-DENSE]", [](const bench::CommandLine& line, bench::Promises& promises) {
    const std::size_t most_dense = line.count(0, 2000, 1000);
    for (const Structure& structure : all) {
      const auto joints = structure.make().joints.size();
      const std::size_t unknowns = (structure.all_elements ? 20 : 6) * joints;
      if (line.quick() && unknowns > 1000) continue;
      measure(structure, unknowns <= most_dense, promises);
    }
  });
}

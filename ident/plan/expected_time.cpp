#include "ident/plan/expected_time.hpp"

#include <algorithm>

#include "base/parallel.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t reference_cores = 2;

/// Of one iteration of one line besides its matrices; and of a solution besides its iterations.
constexpr double bookkeeping_seconds = 3e-5, other_seconds = 0.015;

/// On one core.
double processor_seconds(const Cost& cost) {
  const Iteration& iteration = cost.iteration;
  if (iteration.expected == 0) return 0.0;
  const double each = iteration.flops / reference_pace(iteration.matrix, iteration.complex) +
                      static_cast<double>(cost.lines) * bookkeeping_seconds;
  return other_seconds + static_cast<double>(iteration.expected) * each;
}

/// Least and most of a run over what is expected.
struct Spread {
  double least = 1.0, most = 1.0;
};

Spread spread_of(const Plan& plan) {
  constexpr Spread linearised = {1.0 / 3.0, 4.0}, from_start = {1.0 / 3.0, 25.0}, guessed = {1.0 / 10.0, 6.0};
  if (plan.equations != std::vector{Equation::nn}) return linearised;
  return plan.scene.identify.start.empty() ? guessed : from_start;
}

}  // namespace

double reference_pace(std::size_t matrix, bool complex) {
  const double most = complex ? 16e9 : 12e9,
               half = complex ? 60.0 : 100.0;  // flop/s, and the size at which half of it is reached
  const auto n = static_cast<double>(matrix);
  return most * n / (n + half);
}

double expected_seconds(const Cost& cost, std::size_t threads) {
  const std::size_t used = std::min({threads_or_cores(threads), threads_or_cores(0), std::max<std::size_t>(1, cost.lines)});
  return processor_seconds(cost) / static_cast<double>(used);
}

std::array<double, 2> expected_range_s(const Plan& plan, std::size_t threads) {
  const double expected = expected_seconds(plan.cost, threads);
  const Spread spread = spread_of(plan);
  return {spread.least * expected, spread.most * expected};
}

bool are_expected_within(double seconds, const Cost& cost) {
  const std::size_t used = std::min(reference_cores, std::max<std::size_t>(1, cost.lines));
  return processor_seconds(cost) / static_cast<double>(used) < seconds;
}

}  // namespace jointid::ident

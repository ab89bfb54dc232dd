#include "response/continuation/sweep.hpp"

#include <utility>

namespace jointid::response {

std::vector<HarmonicSolution> sweep(const HarmonicBalance& balance, const std::vector<double>& omegas, double level,
                                    const std::function<void(const std::vector<HarmonicSolution>&)>& advance,
                                    std::vector<HarmonicSolution> begun) {
  std::vector<HarmonicSolution> solutions = std::move(begun);
  solutions.reserve(omegas.size());
  while (solutions.size() < omegas.size()) {
    if (advance) advance(solutions);
    const HarmonicSolution* neighbour = solutions.empty() ? nullptr : &solutions.back();
    solutions.push_back(balance.solve(omegas[solutions.size()], level, neighbour));
  }
  for (std::size_t i = solutions.size(); i-- > 1;) {
    if (solutions[i - 1].converged || !solutions[i].converged) continue;
    HarmonicSolution again = balance.solve(omegas[i - 1], level, &solutions[i]);
    if (again.converged) solutions[i - 1] = std::move(again);
  }
  return solutions;
}

}  // namespace jointid::response

#include "response/continuation/sweep.hpp"

#include <utility>

namespace jointid::response {

std::vector<HarmonicSolution> sweep(const HarmonicBalance& balance, const std::vector<double>& omegas, double level,
                                    const std::function<void(std::size_t)>& advance) {
  std::vector<HarmonicSolution> solutions;
  solutions.reserve(omegas.size());
  for (const double omega : omegas) {
    if (advance) advance(solutions.size());
    const HarmonicSolution* neighbour = solutions.empty() ? nullptr : &solutions.back();
    solutions.push_back(balance.solve(omega, level, neighbour));
  }
  for (std::size_t i = solutions.size(); i-- > 1;) {
    if (solutions[i - 1].converged || !solutions[i].converged) continue;
    HarmonicSolution again = balance.solve(omegas[i - 1], level, &solutions[i]);
    if (again.converged) solutions[i - 1] = std::move(again);
  }
  return solutions;
}

}  // namespace jointid::response

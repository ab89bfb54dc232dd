#include "response/continuation/sweep.hpp"

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
  return solutions;
}

}  // namespace jointid::response

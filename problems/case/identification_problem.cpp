#include "problems/case/identification_problem.hpp"

namespace jointid::problems {

Measurement polluted(const Problem& problem, std::uint64_t seed, std::uint64_t trial) {
  Measurement result;
  const std::size_t parts = problem.substructures.size();
  for (std::size_t i = 0; i < parts; ++i) {
    result.substructures.push_back(
        with_noise(problem.substructures[i], problem.substructure_modes[i], problem.noise, {seed, trial, i}));
  }
  result.assembly = with_noise(problem.assembly, problem.assembly_modes, problem.noise, {seed, trial, parts});
  return result;
}

}  // namespace jointid::problems

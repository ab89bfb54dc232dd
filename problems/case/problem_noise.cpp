#include "problems/case/problem_noise.hpp"

namespace jointid::problems {

frf::FrfSet with_noise(const frf::FrfSet& clean, const Modes& exact, const ProblemNoise& noise,
                       const RandomStream& stream) {
  if (const auto* errors = std::get_if<ConsistentErrors>(&noise))
    return with_modal_errors(clean, exact, *errors, stream);
  return frf::polluted(clean, std::get<frf::NoiseModel>(noise), stream.seed, stream.trial, stream.set);
}

}  // namespace jointid::problems

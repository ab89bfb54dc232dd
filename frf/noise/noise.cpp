#include "frf/noise/noise.hpp"

#include "frf/noise/polluter.hpp"

namespace jointid::frf {

FrfSet polluted(const FrfSet& clean, const NoiseModel& model, std::uint64_t seed, std::uint64_t trial,
                std::uint64_t set) {
  validate(model);
  FrfSet result = clean;
  Polluter(whole(clean), model).pollute(result, {seed, trial, set});
  return result;
}

}  // namespace jointid::frf

#include "study/systematic_noise.hpp"

#include <cmath>

#include "frf/set/quantity.hpp"

namespace jointid::study {
namespace {

constexpr std::uint64_t own_set = 0x9a17;  ///< apart from the sets whose noise is drawn

}  // namespace

void SystematicNoise::apply(frf::FrfSet& set, const RandomStream& stream) const {
  const std::size_t references = set.header.reference.size();
  for (std::size_t r = 0; r < set.header.response.size(); ++r) {
    const frf::Dof& dof = set.header.response[r];
    const auto z = normal_numbers({stream.seed, stream.trial, own_set}, static_cast<std::uint64_t>(coordinate_key(dof)));
    const std::size_t driving = frf::find_coordinate(set.header.reference, dof);
    const double measured = std::exp(-gain * z[0]);
    for (std::size_t line = 0; line < set.header.lines(); ++line) {
      Complex factor = measured;
      if (mass > 0.0 && driving != frf::npos && !dof.is_rotation()) {
        const double frequency = set.header.frequency_hz[line], omega = angular(frequency);
        const double sign = dof.sign * set.header.reference[driving].sign;
        const Complex receptance =
            sign * set.values[set.index(line, r, driving)] * frf::to_receptance(set.header.quantity, frequency);
        factor /= 1.0 - omega * omega * mass * z[1] * receptance;
      }
      for (std::size_t c = 0; c < references; ++c) set.values[set.index(line, r, c)] *= factor;
    }
  }
}

std::string without_driving_point(const frf::FrfHeader& header) {
  for (const frf::Dof& dof : header.response) {
    if (!dof.is_rotation() && !frf::has(header.reference, dof)) return dof.name();
  }
  return "";
}

}  // namespace jointid::study

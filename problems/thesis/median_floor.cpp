#include "problems/thesis/median_floor.hpp"

#include <cmath>
#include <numbers>

#include "base/random.hpp"
#include "base/statistics.hpp"
#include "frf/set/quantity.hpp"

namespace jointid::problems {
namespace {

constexpr std::uint64_t first_floor_set = 1000;  ///< of streams: beyond those of the other errors

/// Receptance over the stored quantity of every line.
std::vector<double> factors(const frf::FrfHeader& header) {
  std::vector<double> all;
  for (const double hz : header.frequency_hz) all.push_back(std::abs(frf::to_receptance(header.quantity, hz)));
  return all;
}

/// Over all lines of the clean set, of which a trial may have only some.
double median_modulus(const frf::FrfSet& clean, const frf::Dof& response, const frf::Dof& reference) {
  const std::size_t r = frf::find_coordinate(clean.header.response, response);
  const std::size_t c = frf::find_coordinate(clean.header.reference, reference);
  const std::vector<double> factor = factors(clean.header);
  std::vector<double> moduli;
  for (std::size_t line = 0; line < factor.size(); ++line)
    moduli.push_back(std::abs(clean.values[clean.index(line, r, c)]) / factor[line]);
  return median(std::move(moduli));
}

/// The same number for an entry and its transpose where the set has both.
std::uint64_t shared_entry(const frf::FrfHeader& header, std::size_t r, std::size_t c) {
  const std::size_t i = frf::find_coordinate(header.reference, header.response[r]);
  const std::size_t j = frf::find_coordinate(header.response, header.reference[c]);
  const std::size_t own = r * header.reference.size() + c;
  return i == frf::npos || j == frf::npos ? own : std::min(own, j * header.reference.size() + i);
}

void add_to_set(frf::FrfSet& set, const frf::FrfSet& clean, double share, const RandomStream& stream) {
  const frf::FrfHeader& header = set.header;
  const std::vector<double> factor = factors(header);
  for (std::size_t r = 0; r < header.response.size(); ++r) {
    for (std::size_t c = 0; c < header.reference.size(); ++c) {
      const double deviation = share * median_modulus(clean, header.response[r], header.reference[c]) / std::numbers::sqrt2;
      const std::uint64_t entry = shared_entry(header, r, c);
      for (std::size_t line = 0; line < factor.size(); ++line) {
        const auto z = normal_numbers(stream, line * header.entries() + entry);
        set.values[set.index(line, r, c)] += deviation * factor[line] * Complex(z[0], z[1]);
      }
    }
  }
}

}  // namespace

void add_median_floor(study::Measurements& data, const study::Measurements& clean, double share, std::uint64_t seed,
                      std::uint64_t trial) {
  std::uint64_t number = first_floor_set;
  for (std::size_t i = 0; i < data.substructures.size(); ++i)
    add_to_set(data.substructures[i], clean.substructures[i], share, {seed, trial, number++});
  for (std::size_t i = 0; i < data.assembly.size(); ++i)
    add_to_set(data.assembly[i], clean.assembly[i], share, {seed, trial, number++});
}

}  // namespace jointid::problems

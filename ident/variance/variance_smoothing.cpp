#include "ident/variance/variance_smoothing.hpp"

#include <cmath>

#include "ident/variance/noise_fit.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t most_smoothed = 512;

/// Complex degrees of freedom behind a recorded variance; of variances that a file just states, a guess.
double freedom(const frf::FrfHeader& header) {
  if (header.repeats > 1) return static_cast<double>(header.repeats - 1);
  return header.averages >= 2.0 ? header.averages - 1.0 : 4.0;
}

}  // namespace

bool worth_smoothing(VarianceOrigin origin, const frf::FrfHeader& header) {
  constexpr std::size_t enough_lines = 30;
  constexpr double many_averages = 30.0;
  const bool few = header.averages < many_averages;
  const bool uncertain = origin == VarianceOrigin::repeats || (origin == VarianceOrigin::coherence && few) ||
                         (origin == VarianceOrigin::variance && header.averages > 0.0 && few);
  return uncertain && header.lines() >= enough_lines;
}

std::vector<frf::VarianceLaw> smoothed_laws(const frf::FrfHeader& header, std::size_t entries, const ReadRecorded& read,
                                            std::span<const std::size_t> lines) {
  std::vector<std::vector<SquaredError>> samples(entries);
  std::vector<Complex> values(entries), variances(entries);
  const std::size_t step = (lines.size() + most_smoothed - 1) / most_smoothed;
  for (std::size_t i = 0; i < lines.size(); i += step) {
    const auto line = lines.subspan(i, 1);
    read(line, values, variances);
    const double factor = frf::squared_factor(header.quantity, header.frequency_hz[line.front()]);
    for (std::size_t entry = 0; entry < entries; ++entry) {
      const double variance = (variances[entry].real() + variances[entry].imag()) / factor;
      const double square = std::norm(values[entry]) / factor;
      if (!std::isfinite(variance) || !std::isfinite(square)) continue;
      samples[entry].push_back(
          {.square = variance, .proportional = square, .constant = 1.0, .freedom = freedom(header)});
    }
  }
  std::vector<frf::VarianceLaw> laws;
  for (const auto& of_entry : samples) laws.push_back(fit_noise(of_entry));
  return laws;
}

}  // namespace jointid::ident

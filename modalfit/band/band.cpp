#include "modalfit/band/band.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "base/complex.hpp"
#include "base/stop_scope.hpp"
#include "frf/set/frf_set.hpp"
#include "frf/set/recorded_variance.hpp"

namespace jointid::modalfit {
namespace {

constexpr std::size_t least_lines = 8;
constexpr double exact = 1e-6;
constexpr double least_receptance = 1e-280, most_receptance = 1e280;

std::vector<std::size_t> lines_in(const frf::FrfHeader& header, const std::optional<std::array<double, 2>>& range) {
  std::vector<std::size_t> lines;
  for (std::size_t i = 0; i < header.lines(); ++i) {
    const double f = header.frequency_hz[i];
    if (f > 0.0 && (!range || (f >= (*range)[0] && f <= (*range)[1]))) lines.push_back(i);
  }
  if (lines.size() < least_lines) {
    fail(header, "range", fmt::format("{} lines are in it; a modal fit needs at least {}", lines.size(), least_lines),
         "widen the range, or measure finer");
  }
  return lines;
}

void weigh_as_recorded(const frf::FrfSet& set, const std::vector<std::size_t>& lines, std::size_t entry, Band& band) {
  double* weight = band.weights(entry);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::size_t at = lines[i] * set.header.entries() + entry;
    const double least = exact * std::abs(set.values[at]);
    const Complex variance = frf::recorded_variance(set, at);
    for (std::size_t part = 0; part < 2; ++part) {
      const double deviation = std::max(std::sqrt(part == 0 ? variance.real() : variance.imag()), least);
      const bool known = std::isfinite(deviation) && deviation > 0.0 && band.value(entry)[i] != 0.0;
      weight[2 * i + part] = known ? 1.0 / deviation : 0.0;
    }
  }
}

/// σ a hundredth of the rms in the stored quantity; `unit` keeps squares in range.
void weigh_evenly(Band& band, std::size_t entry, double unit) {
  double sum = 0.0, count = 0.0;
  const auto stored = [&](std::size_t i) {
    return unit * std::abs(frf::from_receptance(band.quantity, band.frequency_hz[i]));
  };
  for (std::size_t i = 0; i < band.lines(); ++i) {
    if (band.value(entry)[i] == 0.0) continue;
    sum += std::norm(band.value(entry)[i] * stored(i));
    count += 1.0;
  }
  if (!(sum > 0.0)) return;
  for (std::size_t i = 0; i < band.lines(); ++i) {
    const double weight = band.value(entry)[i] == 0.0 ? 0.0 : stored(i) / (0.01 * std::sqrt(sum / count));
    band.weights(entry)[2 * i] = band.weights(entry)[2 * i + 1] = weight;
  }
}

double largest_part(const Band& band) {
  double largest = 0.0;
  for (const Complex& value : band.values) largest = std::max({largest, std::abs(value.real()), std::abs(value.imag())});
  return largest;
}

/// FRFs below this share of the largest are 0: their variances are no numbers beside those of the others.
constexpr double least_beside = 1e-100;

void drop_tiny(Band& band) {
  const double least = least_beside * largest_part(band);
  for (std::size_t e = 0; e < band.entries(); ++e) {
    const std::span<Complex> values(band.values.data() + e * band.lines(), band.lines());
    const bool tiny = std::ranges::all_of(values, [&](Complex v) { return std::abs(v.real()) < least && std::abs(v.imag()) < least; });
    if (tiny) std::ranges::fill(values, Complex(0.0));
  }
}

/// Receptances on the band's lines; 0 where not measured.
void take_values(const frf::FrfSet& set, const std::vector<std::size_t>& lines, Band& band) {
  band.values.resize(band.entries() * lines.size());
  for (std::size_t entry = 0; entry < band.entries(); ++entry) {
    stop_point();
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const Complex value = set.values[lines[i] * set.header.entries() + entry];
      band.values[entry * lines.size() + i] = std::isfinite(value.real()) && std::isfinite(value.imag()) ? value : 0.0;
    }
  }
}

void require_numbers(const frf::FrfHeader& header, const Band& band) {
  const double largest = largest_part(band);
  if (largest == 0.0) fail(header, "range", "on its lines all FRFs are 0 or were not measured", "choose other lines, or look at the file");
  if (largest >= least_receptance && largest <= most_receptance) return;
  fail(header, "FRFs",
       fmt::format("the largest receptance is {:.3g} m/N, outside {:.0g} to {:.0g}", largest, least_receptance, most_receptance),
       "look at the unit and the numbers of the file");
}

}  // namespace

Band make_band(const frf::FrfSet& set, const std::optional<std::array<double, 2>>& range_hz) {
  const std::vector<std::size_t> lines = lines_in(set.header, range_hz);
  Band band;
  for (const std::size_t line : lines) band.frequency_hz.push_back(set.header.frequency_hz[line]);
  band.responses = set.header.response.size();
  band.references = set.header.reference.size();
  band.known_noise = frf::knows_noise(set);
  band.quantity = set.header.quantity;
  band.precision = set.header.precision;
  take_values(set, lines, band);
  require_numbers(set.header, band);
  drop_tiny(band);
  band.weight.resize(band.values.size() * 2);
  const double unit = unit_of(band);
  for (std::size_t entry = 0; entry < band.entries(); ++entry) {
    stop_point();
    band.known_noise ? weigh_as_recorded(set, lines, entry, band) : weigh_evenly(band, entry, 1.0 / unit);
  }
  if (std::ranges::all_of(band.weight, [](double weight) { return weight == 0.0; })) {
    fail(set.header, "range", "nothing was measured on its lines", "choose other lines");
  }
  return band;
}

double unit_of(const Band& band) { return std::ldexp(1.0, 2 * (std::ilogb(largest_part(band)) / 2)); }

void multiply(Band& band, double factor) {
  for (Complex& value : band.values) value *= factor;
  for (double& weight : band.weight) weight /= factor;
}

}  // namespace jointid::modalfit

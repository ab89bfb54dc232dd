#include "frf/noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "frf/error.hpp"
#include "frf/random.hpp"

namespace jointid::frf {
namespace {

constexpr std::array<const char*, 4> kind_names = {"uniform", "gaussian", "circular", "hammer"};

void require(bool holds, const char* place, double value, const char* remedy) {
  if (holds) return;
  throw InputError({.kind = ErrorKind::usage,
                    .file = {},
                    .place = place,
                    .problem = "it is " + std::to_string(value),
                    .remedy = remedy});
}

/// For each entry of a line the smaller index of itself and its reciprocal.
std::vector<std::size_t> canonical_entries(const FrfHeader& header) {
  const std::size_t columns = header.reference.size();
  std::vector<std::size_t> canonical(header.entries());
  for (std::size_t r = 0; r < header.response.size(); ++r) {
    const std::size_t mirrored_column = find_coordinate(header.reference, header.response[r]);
    for (std::size_t c = 0; c < columns; ++c) {
      const std::size_t mirrored_row = find_coordinate(header.response, header.reference[c]);
      const std::size_t entry = r * columns + c;
      const bool has_both = mirrored_row != npos && mirrored_column != npos;
      canonical[entry] = has_both ? std::min(entry, mirrored_row * columns + mirrored_column) : entry;
    }
  }
  return canonical;
}

struct Deviation {
  Complex value;     ///< Ĥ
  Complex variance;  ///< of real and imaginary part, from Ĥ
};

/// Ĥ = (f₁ Re H, f₂ Im H), both factors of variance p²/3.
Deviation scale_parts(Complex exact, double level, double first, double second) {
  const Complex value(exact.real() * first, exact.imag() * second);
  const double relative = level * level / 3.0;
  return {value, Complex(relative * value.real() * value.real(), relative * value.imag() * value.imag())};
}

Deviation deviate(Complex exact, const NoiseModel& model, const RandomStream& stream, std::uint64_t counter) {
  const double p = model.level;
  if (model.kind == NoiseKind::uniform) {
    const auto u = uniform_numbers(stream, counter);
    return scale_parts(exact, p, 1.0 + p * (2.0 * u[0] - 1.0), 1.0 + p * (2.0 * u[1] - 1.0));
  }
  const auto z = normal_numbers(stream, counter);
  if (model.kind == NoiseKind::gaussian) {
    const double deviation = p / std::numbers::sqrt3;
    return scale_parts(exact, p, 1.0 + deviation * z[0], 1.0 + deviation * z[1]);
  }
  const Complex value = exact * (1.0 + p / std::numbers::sqrt2 * Complex(z[0], z[1]));
  const double part = 0.5 * p * p * std::norm(value);
  return {value, Complex(part, part)};
}

void add_proportional_noise(FrfSet& set, const NoiseModel& model, const RandomStream& stream) {
  const std::vector<std::size_t> canonical = canonical_entries(set.header);
  if (model.record_variance) set.variance.resize(set.values.size());
  for (std::size_t i = 0; i < set.values.size(); ++i) {
    const std::size_t line_start = i - i % canonical.size();
    const Deviation noisy = deviate(set.values[i], model, stream, line_start + canonical[i - line_start]);
    set.values[i] = noisy.value;
    if (model.record_variance) set.variance[i] = noisy.variance;
  }
  if (model.record_variance) set.header.noise = NoiseRecord::variance;
}

/// Gamma(shape, 1) for integer shape ≥ 1: a sum of exponentials, four to a block from block 1 on.
double gamma_number(int shape, const RandomStream& stream, std::uint64_t counter) {
  double sum = 0.0;
  std::array<double, 4> u{};
  for (unsigned k = 0; k < static_cast<unsigned>(shape); ++k) {
    if (k % 4 == 0) u = uniform_numbers(stream, counter, 1 + k / 4);
    sum -= std::log(u[k % 4]);
  }
  return sum;
}

void add_hammer_noise(FrfSet& set, const NoiseModel& model, const RandomStream& stream) {
  if (set.coherence.empty()) set.coherence.assign(set.values.size(), model.coherence);
  for (std::size_t i = 0; i < set.values.size(); ++i) {
    const double coherence = set.coherence[i];
    if (std::isnan(set.values[i].real()) || std::isnan(coherence)) continue;
    require(coherence > 0.0 && coherence <= 1.0, "coherence of the FRF set", coherence,
            "0 < coherence <= 1 is needed");
    const double variance = std::norm(set.values[i]) * (1.0 - coherence) / (coherence * (model.averages - 1));
    const auto z = normal_numbers(stream, i);
    set.values[i] += std::sqrt(0.5 * variance) * Complex(z[0], z[1]);
    const double signal = std::norm(set.values[i]);
    const double residual = variance * gamma_number(model.averages - 1, stream, i);
    set.coherence[i] = signal > 0.0 ? signal / (signal + residual) : coherence;
  }
  set.header.noise = NoiseRecord::coherence;
  set.header.averages = model.averages;
}

}  // namespace

std::string name(NoiseKind kind) { return kind_names[static_cast<std::size_t>(kind)]; }

NoiseKind parse_noise_kind(std::string_view text) {
  for (std::size_t i = 0; i < kind_names.size(); ++i) {
    if (text == kind_names[i]) return static_cast<NoiseKind>(i);
  }
  const std::string near = nearest_word(std::string(text), kind_names);
  throw InputError(
      {.kind = ErrorKind::usage,
       .file = {},
       .place = "noise model",
       .problem = "'" + std::string(text) + "' is not a noise model",
       .remedy = near.empty() ? "use uniform, gaussian, circular or hammer" : "did you mean " + near + "?"});
}

void validate(const NoiseModel& model) {
  if (model.kind != NoiseKind::hammer) {
    require(model.level >= 0.0 && model.level < 1.0, "noise level", model.level, "0 <= level < 1 is needed");
    return;
  }
  require(model.coherence > 0.0 && model.coherence <= 1.0, "noise coherence", model.coherence,
          "0 < coherence <= 1 is needed");
  require(model.averages >= 2, "noise averages", model.averages,
          "one average tells nothing of the noise; use 2 or more");
}

FrfSet polluted(const FrfSet& clean, const NoiseModel& model, std::uint64_t seed, std::uint64_t trial,
                std::uint64_t set) {
  validate(model);
  FrfSet result = clean;
  const RandomStream stream{seed, trial, set};
  if (model.kind == NoiseKind::hammer) {
    add_hammer_noise(result, model, stream);
  } else {
    add_proportional_noise(result, model, stream);
  }
  return result;
}

}  // namespace jointid::frf

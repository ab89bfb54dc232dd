#include "frf/noise/polluter.hpp"

#include <cmath>
#include <numbers>
#include <unordered_map>

#include "base/error.hpp"
#include "frf/set/h1.hpp"

namespace jointid::frf {
namespace {

/// Blocks of a counter that the errors beyond the kind's own draw from.
constexpr std::uint64_t gross_block = std::uint64_t{1} << 32, floor_block = gross_block + 1;

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

Deviation deviate(NoiseKind kind, Complex exact, double level, double first, double second) {
  if (kind == NoiseKind::uniform) return scale_parts(exact, level, 1.0 + level * first, 1.0 + level * second);
  if (kind == NoiseKind::gaussian) {
    const double deviation = level / std::numbers::sqrt3;
    return scale_parts(exact, level, 1.0 + deviation * first, 1.0 + deviation * second);
  }
  const Complex value = exact * (1.0 + level / std::numbers::sqrt2 * Complex(first, second));
  const double part = 0.5 * level * level * std::norm(value);
  return {value, Complex(part, part)};
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

void require_coherence(double coherence) {
  if (coherence > 0.0 && coherence <= 1.0) return;
  throw InputError({.kind = ErrorKind::usage,
                    .file = {},
                    .place = "coherence of the FRF set",
                    .problem = "it is " + std::to_string(coherence),
                    .remedy = "0 < coherence <= 1 is needed"});
}

}  // namespace

Polluter::Polluter(const Excerpt& clean, const NoiseModel& model)
    : model_(model), line_start_(clean.line_start), entry_(clean.entry) {
  find_draws(clean);
  if (model.floor > 0.0) find_floor(clean.set);
  if (model.sign_errors > 0.0 || model.position_errors > 0.0) {
    dof_errors_.emplace(clean.set.header, model.sign_errors, model.position_errors);
  }
}

void Polluter::find_draws(const Excerpt& clean) {
  const std::vector<std::uint64_t>& from = model_.reciprocal ? clean.shared : clean.entry;
  std::unordered_map<std::uint64_t, std::size_t> known;
  for (const std::uint64_t counter : from) {
    const auto [place, is_new] = known.try_emplace(counter, counters_.size());
    if (is_new) counters_.push_back(counter);
    draw_of_.push_back(place->second);
  }
  draws_.resize(counters_.size());
}

void Polluter::find_floor(const FrfSet& clean) {
  const std::size_t entries = clean.header.entries();
  const auto factor = [&](std::size_t i) {
    return std::abs(to_receptance(clean.header.quantity, clean.header.frequency_hz[i / entries]));
  };
  std::vector<double> squares(entries, 0.0), counts(entries, 0.0);
  for (std::size_t i = 0; i < clean.values.size(); ++i) {
    const double stored = std::norm(clean.values[i]) / (factor(i) * factor(i));
    if (!std::isfinite(stored)) continue;
    squares[i % entries] += stored;
    counts[i % entries] += 1.0;
  }
  floor_.reserve(clean.values.size());
  for (std::size_t i = 0; i < clean.values.size(); ++i) {
    floor_.push_back(model_.floor * std::sqrt(squares[i % entries] / counts[i % entries]) * factor(i));
  }
}

void Polluter::pollute(FrfSet& set, const RandomStream& stream) {
  if (dof_errors_) dof_errors_->apply(set, stream);
  const bool hammer = model_.kind == NoiseKind::hammer;
  if (hammer && set.coherence.empty()) set.coherence.assign(set.values.size(), model_.coherence);
  if (!hammer && model_.record_variance) set.variance.resize(set.values.size());
  for (std::size_t line = 0; line < line_start_.size(); ++line) {
    const double factor = gross_factor(stream, line_start_[line]);
    if (hammer) {
      add_hammer_noise(set, stream, line, factor);
    } else {
      draw_line(stream, line_start_[line]);
      add_proportional_noise(set, line, model_.level * factor);
    }
    if (!floor_.empty()) add_floor(set, stream, line, factor);
  }
  if (hammer) {
    set.header.noise = NoiseRecord::coherence;
    set.header.averages = model_.averages;
  } else if (model_.record_variance) {
    set.header.noise = NoiseRecord::variance;
  }
}

double Polluter::gross_factor(const RandomStream& stream, std::uint64_t line_start) const {
  if (model_.gross.share == 0.0) return 1.0;
  return uniform_numbers(stream, line_start, gross_block)[0] < model_.gross.share ? model_.gross.factor : 1.0;
}

void Polluter::draw_line(const RandomStream& stream, std::uint64_t line_start) {
  for (std::size_t i = 0; i < counters_.size(); ++i) {
    if (model_.kind == NoiseKind::uniform) {
      const auto u = uniform_numbers(stream, line_start + counters_[i]);
      draws_[i] = {2.0 * u[0] - 1.0, 2.0 * u[1] - 1.0};
    } else {
      const auto z = normal_numbers(stream, line_start + counters_[i]);
      draws_[i] = {z[0], z[1]};
    }
  }
}

void Polluter::add_proportional_noise(FrfSet& set, std::size_t line, double level) const {
  const std::size_t first = line * draw_of_.size();
  for (std::size_t i = 0; i < draw_of_.size(); ++i) {
    const Draw& draw = draws_[draw_of_[i]];
    const Deviation noisy = deviate(model_.kind, set.values[first + i], level, draw.first, draw.second);
    set.values[first + i] = noisy.value;
    if (!model_.record_variance) continue;
    const double floor = floor_.empty() ? 0.0 : 0.5 * floor_[first + i] * floor_[first + i];
    set.variance[first + i] = noisy.variance + Complex(floor, floor);
  }
}

void Polluter::add_hammer_noise(FrfSet& set, const RandomStream& stream, std::size_t line, double factor) const {
  for (std::size_t i = 0; i < entry_.size(); ++i) {
    Complex& value = set.values[line * entry_.size() + i];
    double& coherence = set.coherence[line * entry_.size() + i];
    if (std::isnan(value.real()) || std::isnan(coherence)) continue;
    require_coherence(coherence);
    const std::uint64_t counter = line_start_[line] + entry_[i];
    const double variance = h1_variance(value, coherence, model_.averages);
    const auto z = normal_numbers(stream, counter);
    value += factor * std::sqrt(0.5 * variance) * Complex(z[0], z[1]);
    const double signal = std::norm(value);
    const double residual = factor * factor * variance * gamma_number(model_.averages - 1, stream, counter);
    coherence = signal > 0.0 ? signal / (signal + residual) : coherence;
  }
}

void Polluter::add_floor(FrfSet& set, const RandomStream& stream, std::size_t line, double factor) const {
  const std::size_t first = line * draw_of_.size();
  for (std::size_t i = 0; i < draw_of_.size(); ++i) {
    const double deviation = floor_[first + i];
    if (!(deviation > 0.0)) continue;  // no receptance at 0 Hz from an accelerance
    const auto z = normal_numbers(stream, line_start_[line] + counters_[draw_of_[i]], floor_block);
    set.values[first + i] += factor * deviation / std::numbers::sqrt2 * Complex(z[0], z[1]);
  }
}

}  // namespace jointid::frf

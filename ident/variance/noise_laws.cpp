#include "ident/variance/noise_laws.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/eigen.hpp"
#include "base/error.hpp"
#include "base/statistics.hpp"
#include "frf/noise/variance_law.hpp"
#include "frf/set/h1.hpp"
#include "ident/scene/variance_origin.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t usual_law_lines = 32, least_law_lines = 8;
constexpr double most_records = 1e6;  ///< numbers read

std::vector<std::size_t> indices_up_to(std::size_t count) {
  std::vector<std::size_t> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = i;
  return all;
}

/// Nothing where the file has none, or they do not count, or they say nothing.
std::optional<VarianceOrigin> recorded_origin(const Scene& scene, const frf::FrfHeader& header) {
  if (header.noise == frf::NoiseRecord::none) return std::nullopt;
  try {
    const VarianceOrigin origin = variance_origin(scene, header);
    const bool is_recorded =
        origin == VarianceOrigin::variance || origin == VarianceOrigin::repeats || origin == VarianceOrigin::coherence;
    return is_recorded ? std::optional(origin) : std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;  // solve says so
  }
}

/// E|e|² of every FRF of a block.
std::vector<double> error_squares(frf::FrfSource& source, const frf::Block& block, VarianceOrigin origin,
                                  std::span<const Complex> values) {
  std::vector<double> out(block.size());
  if (origin != VarianceOrigin::coherence) {
    std::vector<Complex> parts(block.size());
    source.read_variance(block, parts);
    std::ranges::transform(parts, out.begin(), [](const Complex& v) { return v.real() + v.imag(); });
    return out;
  }
  std::vector<double> coherences(block.size());
  source.read_coherence(block, coherences);
  const double averages = source.header().averages;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Complex parts = frf::h1_part_variances(values[i], coherences[i], averages);
    out[i] = parts.real() + parts.imag();
  }
  return out;
}

}  // namespace

namespace {

/// Without errors of another law than most: dropouts.
std::vector<NoiseSample> usual_samples(const std::vector<NoiseSample>& samples) {
  constexpr double dropout = 300.0;  // times what the middle ones of error over square and over factor make together
  std::vector<double> of_squares, of_factors;
  for (const auto& [error, square, factor] : samples) {
    if (square > 0.0) of_squares.push_back(error / square);
    if (factor > 0.0) of_factors.push_back(error / factor);
  }
  if (of_squares.empty() || of_factors.empty()) return samples;
  const double a = median(of_squares), b = median(of_factors);
  if (!(a > 0.0 && b > 0.0)) return samples;
  std::vector<NoiseSample> usual = samples;
  std::erase_if(usual,
                [&](const NoiseSample& each) { return each.error_square > dropout * (a * each.square + b * each.factor); });
  return usual;
}

}  // namespace

std::pair<double, double> fit_noise_law(const std::vector<NoiseSample>& all) {
  if (all.size() < 3) return {nan, nan};
  const std::vector<NoiseSample> samples = usual_samples(all);
  double v = 0.0, x = 0.0, y = 0.0;
  for (const auto& [error, square, factor] : samples) {
    v += error;
    x += square;
    y += factor;
  }
  if (!(v > 0.0 && x > 0.0 && y > 0.0)) return {0.0, 0.0};
  double a = 0.5 * v / x, b = 0.5 * v / y;
  for (int iteration = 0; iteration < 6; ++iteration) {
    double xx = 0.0, xy = 0.0, yy = 0.0, xv = 0.0, yv = 0.0;
    for (const auto& [error, square, factor] : samples) {
      const double expected = a * square + b * factor;
      if (!(expected > 0.0)) continue;
      const double weight = 1.0 / (expected * expected);
      xx += weight * square * square;
      xy += weight * square * factor;
      yy += weight * factor * factor;
      xv += weight * square * error;
      yv += weight * factor * error;
    }
    const double determinant = xx * yy - xy * xy;
    double next_a = determinant > 1e-12 * xx * yy ? (yy * xv - xy * yv) / determinant : xv / xx, next_b = (yv - xy * next_a) / yy;
    if (!(next_a > 0.0)) {
      next_a = 0.0;
      next_b = yv / yy;
    } else if (!(next_b > 0.0)) {
      next_a = xv / xx;
      next_b = 0.0;
    }
    a = next_a;
    b = next_b;
  }
  return {a, b};
}

std::vector<double> recorded_squares(frf::FrfSource& source, const std::vector<std::size_t>& source_lines,
                                     std::span<const Complex> values, const Scene& scene) {
  const frf::FrfHeader& header = source.header();
  const auto origin = recorded_origin(scene, header);
  if (origin != VarianceOrigin::variance || static_cast<double>(source_lines.size() * header.entries()) > most_records) return {};
  const auto rows = indices_up_to(header.response.size()), columns = indices_up_to(header.reference.size());
  return error_squares(source, {source_lines, rows, columns}, *origin, values);
}

std::shared_ptr<const NoiseLaws> recorded_laws(frf::FrfSource& source, const std::vector<std::size_t>& source_lines,
                                               std::span<const Complex> values, const Scene& scene) {
  const frf::FrfHeader& header = source.header();
  const auto origin = recorded_origin(scene, header);
  if (!origin) return nullptr;
  const std::size_t entries = header.entries();
  const auto affordable = static_cast<std::size_t>(most_records / static_cast<double>(entries));
  std::vector<std::size_t> lines;
  std::vector<Complex> some;
  for (const std::size_t l : spread_lines(source_lines.size(), std::clamp(affordable, least_law_lines, usual_law_lines))) {
    lines.push_back(source_lines[l]);
    const auto line = values.subspan(l * entries, entries);
    some.insert(some.end(), line.begin(), line.end());
  }
  const auto rows = indices_up_to(header.response.size()), columns = indices_up_to(header.reference.size());
  const std::vector<double> errors = error_squares(source, {lines, rows, columns}, *origin, some);
  NoiseLaws laws{.proportional = Eigen::MatrixXd(at(rows.size()), at(columns.size())),
                 .constant = Eigen::MatrixXd(at(rows.size()), at(columns.size()))};
  std::vector<NoiseSample> samples;
  for (std::size_t e = 0; e < entries; ++e) {
    samples.clear();
    for (std::size_t l = 0; l < lines.size(); ++l) {
      const double factor = frf::squared_factor(header.quantity, header.frequency_hz[lines[l]]);
      const double error = errors[l * entries + e], square = std::norm(some[l * entries + e]);
      if (std::isfinite(error) && std::isfinite(square) && std::isfinite(factor)) samples.push_back({error, square, factor});
    }
    const auto [proportional, constant] = fit_noise_law(samples);
    laws.proportional(at(e / columns.size()), at(e % columns.size())) = proportional;
    laws.constant(at(e / columns.size()), at(e % columns.size())) = constant;
  }
  const bool any = (laws.proportional.array() > 0.0).any() || (laws.constant.array() > 0.0).any();
  if (!any && *origin == VarianceOrigin::repeats) return nullptr;  // one run twice: find_equal_runs()
  return std::make_shared<const NoiseLaws>(std::move(laws));
}

std::vector<std::size_t> spread_lines(std::size_t size, std::size_t count) {
  std::vector<std::size_t> lines;
  const bool all = size <= count;
  for (std::size_t i = 0; i < (all ? size : count); ++i) lines.push_back(all ? i : i * (size - 1) / (count - 1));
  return lines;
}

}  // namespace jointid::ident

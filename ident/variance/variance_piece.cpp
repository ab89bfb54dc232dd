#include "ident/variance/variance_piece.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "frf/set/h1.hpp"
#include "ident/variance/scatter.hpp"
#include "ident/variance/variance_smoothing.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t lines_at_once = 64;

}  // namespace

VariancePiece::VariancePiece(frf::FrfSource& source, frf::BlockPiece piece, const Scene& scene)
    : source_(source),
      piece_(std::move(piece)),
      origin_(variance_origin(scene, source.header())),
      smooth_(origin_ != VarianceOrigin::model && scene.identify.smooth_variance.value_or(worth_smoothing(origin_, source.header()))) {
  if (origin_ != VarianceOrigin::noise_model) return;
  model_ = scene.noise->frf_model;
  if (!needs_prepare()) laws_.assign(piece_.size(), frf::variance_law(model_, 0.0));
}

bool VariancePiece::is_recorded() const {
  return origin_ != VarianceOrigin::noise_model && origin_ != VarianceOrigin::scatter;
}

bool VariancePiece::needs_prepare() const {
  if (origin_ == VarianceOrigin::noise_model) return model_.floor > 0.0;
  return origin_ == VarianceOrigin::scatter || smooth_;
}

void VariancePiece::prepare(std::span<const std::size_t> lines) {
  if (!needs_prepare()) return;
  if (origin_ == VarianceOrigin::noise_model) {
    laws_ = laws_with_floor();
  } else if (origin_ == VarianceOrigin::scatter) {
    Scatter found = estimate_scatter(source_, piece_, lines);
    laws_ = std::move(found.laws);
    unresolved_ = found.unresolved;
  } else {
    const auto recorded = [this](std::span<const std::size_t> line, std::span<Complex> values, std::span<Complex> variances) {
      read_values(line, values);
      read_recorded(line, values, variances);
    };
    laws_ = smoothed_laws(source_.header(), piece_.size(), recorded, lines);
  }
}

/// The floor is a share of the rms over all lines of the file: those that a scene leaves out do not change its noise.
std::vector<frf::VarianceLaw> VariancePiece::laws_with_floor() {
  const frf::FrfHeader& header = source_.header();
  std::vector<std::size_t> all(header.lines());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const std::span<const std::size_t> lines = all;
  const std::size_t entries = piece_.size();
  std::vector<double> squares(entries, 0.0), counts(entries, 0.0);
  std::vector<Complex> values;
  for (std::size_t first = 0; first < lines.size(); first += lines_at_once) {
    const auto some = lines.subspan(first, std::min(lines_at_once, lines.size() - first));
    values.resize(some.size() * entries);
    read_values(some, values);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double stored =
          std::norm(values[i]) / frf::squared_factor(header.quantity, header.frequency_hz[some[i / entries]]);
      if (!std::isfinite(stored)) continue;
      squares[i % entries] += stored;
      counts[i % entries] += 1.0;
    }
  }
  std::vector<frf::VarianceLaw> laws;
  for (std::size_t i = 0; i < entries; ++i) {
    laws.push_back(frf::variance_law(model_, counts[i] > 0.0 ? squares[i] / counts[i] : 0.0));
  }
  return laws;
}

void VariancePiece::read_values(std::span<const std::size_t> lines, std::span<Complex> out) { source_.read(block(lines), out); }

void VariancePiece::read(std::span<const std::size_t> lines, std::span<const Complex> values, std::span<Complex> out) {
  is_recorded() && !smooth_ ? read_recorded(lines, values, out) : from_law(lines, values, out);
}

void VariancePiece::read_recorded(std::span<const std::size_t> lines, std::span<const Complex> values,
                                  std::span<Complex> out) {
  assert(is_recorded());
  origin_ == VarianceOrigin::coherence ? from_coherence(lines, values, out) : source_.read_variance(block(lines), out);
}

void VariancePiece::from_coherence(std::span<const std::size_t> lines, std::span<const Complex> values,
                                   std::span<Complex> out) {
  coherence_.resize(values.size());
  source_.read_coherence(block(lines), coherence_);
  const double averages = source_.header().averages;
  for (std::size_t i = 0; i < values.size(); ++i) {
    out[i] = frf::h1_part_variances(values[i], coherence_[i], averages);
  }
}

void VariancePiece::from_law(std::span<const std::size_t> lines, std::span<const Complex> values,
                             std::span<Complex> out) const {
  assert(laws_.size() == piece_.size());
  const frf::FrfHeader& header = source_.header();
  for (std::size_t line = 0, i = 0; line < lines.size(); ++line) {
    const double factor = frf::squared_factor(header.quantity, header.frequency_hz[lines[line]]);
    for (const frf::VarianceLaw& law : laws_) {
      out[i] = law(values[i], factor);
      ++i;
    }
  }
}

}  // namespace jointid::ident

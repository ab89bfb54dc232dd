#include "ident/variance_piece.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "frf/h1.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t lines_at_once = 64;

}  // namespace

VariancePiece::VariancePiece(frf::FrfSource& source, frf::BlockPiece piece, const Scene& scene)
    : source_(source), piece_(std::move(piece)), origin_(variance_origin(scene, source.header())) {
  if (origin_ != VarianceOrigin::noise_model) return;
  model_ = scene.noise->frf_model;
  if (!needs_prepare()) laws_.assign(piece_.size(), frf::variance_law(model_, 0.0));
}

bool VariancePiece::needs_prepare() const { return origin_ == VarianceOrigin::noise_model && model_.floor > 0.0; }

void VariancePiece::prepare(std::span<const std::size_t> lines) {
  if (!needs_prepare()) return;
  const frf::FrfHeader& header = source_.header();
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
  laws_.clear();
  for (std::size_t i = 0; i < entries; ++i) {
    laws_.push_back(frf::variance_law(model_, counts[i] > 0.0 ? squares[i] / counts[i] : 0.0));
  }
}

void VariancePiece::read_values(std::span<const std::size_t> lines, std::span<Complex> out) { source_.read(block(lines), out); }

void VariancePiece::read(std::span<const std::size_t> lines, std::span<const Complex> values, std::span<Complex> out) {
  switch (origin_) {
    case VarianceOrigin::variance:
      source_.read_variance(block(lines), out);
      break;
    case VarianceOrigin::coherence:
      from_coherence(lines, values, out);
      break;
    case VarianceOrigin::noise_model:
      from_law(lines, values, out);
      break;
  }
}

void VariancePiece::from_coherence(std::span<const std::size_t> lines, std::span<const Complex> values,
                                   std::span<Complex> out) {
  coherence_.resize(values.size());
  source_.read_coherence(block(lines), coherence_);
  const double averages = source_.header().averages;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double coherence = std::min(coherence_[i], 1.0);
    const double part = coherence > 0.0 ? 0.5 * frf::h1_variance(values[i], coherence, averages)
                                        : std::numeric_limits<double>::quiet_NaN();
    out[i] = {part, part};
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

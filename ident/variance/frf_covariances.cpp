#include "ident/variance/frf_covariances.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "base/statistics.hpp"
#include "frf/noise/variance_law.hpp"
#include "ident/scene/variance_origin.hpp"
#include "ident/variance/file_covariance.hpp"
#include "ident/variance/variance_smoothing.hpp"

namespace jointid::ident {
namespace {

using Eigen::MatrixXcd;
using Eigen::VectorXcd;

constexpr std::size_t most_samples = 128;

bool is_law(const frf::FrfHeader& header, const Scene& scene) {
  return scene.identify.smooth_variance.value_or(worth_smoothing(variance_origin(scene, header), header));
}

/// What a covariance of `freedom` degrees is worth as it is: drawn towards its diagonal by n/(n + freedom), n FRFs, lest it promise
/// what it cannot know. Freedom 0: not known, and taken as it stands.
void shrink(MatrixXcd& covariance, double freedom) {
  if (freedom <= 0.0) return;
  const double n = static_cast<double>(covariance.rows());
  const VectorXcd diagonal = covariance.diagonal();
  covariance *= freedom / (n + freedom);
  covariance.diagonal() = diagonal;
}

}  // namespace

FrfCovariances::FrfCovariances(frf::FrfSystem& system, const Scene& scene, const std::vector<frf::Dof>& coordinates,
                               const std::vector<Rectangle>& rectangles)
    : system_(system), size_(coordinates.size()) {
  const auto pick = [&](const std::vector<std::size_t>& which) {
    std::vector<frf::Dof> out;
    for (const std::size_t i : which) out.push_back(coordinates[i]);
    return out;
  };
  for (const Rectangle& rectangle : rectangles) {
    for (const frf::BlockPiece& piece : system.pieces(pick(rectangle.rows), pick(rectangle.columns))) {
      const frf::FrfSource& source = system.source(piece.source);
      if (covariances_count(source, scene)) add(piece, rectangle, is_law(source.header(), scene));
    }
  }
}

void FrfCovariances::add(const frf::BlockPiece& piece, const Rectangle& rectangle, bool by_law) {
  places_.resize(size_ * size_);
  for (std::size_t r = 0; r < piece.responses.size(); ++r) {
    for (std::size_t c = 0; c < piece.references.size(); ++c) {
      const std::size_t place = piece.place(r, c, rectangle.columns.size());
      const std::size_t row = rectangle.rows[place / rectangle.columns.size()];
      const std::size_t column = rectangle.columns[place % rectangle.columns.size()];
      StoredError error = stored(piece.source, piece.responses[r], piece.references[c], by_law);
      error.sign = piece.response_sign[r] * piece.reference_sign[c];
      Place& of = places_[row * size_ + column];
      (piece.transposed ? of.mirrored : of.direct) = error;
    }
  }
}

StoredError FrfCovariances::stored(std::size_t source, std::size_t response, std::size_t reference, bool by_law) {
  auto group = std::ranges::find_if(groups_, [&](const Group& g) { return g.source == source && g.reference == reference; });
  if (group == groups_.end()) group = groups_.insert(groups_.end(), {source, reference, {}, by_law, {}});
  auto member = std::ranges::find(group->responses, response);
  if (member == group->responses.end()) member = group->responses.insert(group->responses.end(), response);
  return {static_cast<std::size_t>(group - groups_.begin()), static_cast<std::size_t>(member - group->responses.begin())};
}

std::vector<std::size_t> FrfCovariances::source_lines(const Group& group, std::span<const std::size_t> lines) const {
  std::vector<std::size_t> out;
  for (const std::size_t line : lines) out.push_back(system_.source_line(group.source, line));
  return out;
}

void FrfCovariances::prepare(std::span<const std::size_t> lines) {
  const std::size_t step = (lines.size() + most_samples - 1) / most_samples;
  std::vector<std::size_t> some;
  for (std::size_t i = 0; i < lines.size(); i += step) some.push_back(lines[i]);
  for (Group& group : groups_) {
    if (!group.by_law) continue;
    frf::FrfSource& source = system_.source(group.source);
    const std::vector<std::size_t> at_lines = source_lines(group, some);
    const StoredGroup stored = read_stored(source, group.responses, group.reference, at_lines);
    std::vector<CovarianceSample> samples;
    for (std::size_t i = 0; i < at_lines.size(); ++i) samples.push_back(sample_of(stored, i, source.header(), at_lines[i]));
    group.law = law_of(samples, source.header(), group.responses.size());
  }
}

void FrfCovariances::read(std::span<const std::size_t> lines) {
  covariances_.assign(lines.size(), {});
  measured_.assign(lines.size(), {});
  for (const Group& group : groups_) {
    frf::FrfSource& source = system_.source(group.source);
    const std::vector<std::size_t> at_lines = source_lines(group, lines);
    const StoredGroup stored = read_stored(source, group.responses, group.reference, at_lines);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const VectorXcd frf = stored.frf(i);
      MatrixXcd covariance = stored.covariance(i);
      if (group.law.constant.size() > 0) {
        const double factor = frf::squared_factor(source.header().quantity, source.header().frequency_hz[at_lines[i]]);
        covariance = group.law(frf, factor);
      } else {
        shrink(covariance, freedom_of(source.header()));
      }
      std::vector<bool> measured;
      for (const Complex& value : frf) measured.push_back(!std::isnan(value.real()));
      covariances_[i].push_back(std::move(covariance));
      measured_[i].push_back(std::move(measured));
    }
  }
}

StoredError FrfCovariances::error(std::size_t i, std::size_t row, std::size_t column) const {
  const Place& place = places_[row * size_ + column];
  if (place.direct.is_known() && measured_[i][place.direct.group][place.direct.member]) return place.direct;
  return place.mirrored;
}

}  // namespace jointid::ident

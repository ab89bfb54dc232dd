#include "ident/variance/frf_covariances.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "base/statistics.hpp"
#include "dense/cholesky.hpp"
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
      StoredFrf frf = stored(piece.source, piece.responses[r], piece.references[c], by_law);
      frf.sign = piece.response_sign[r] * piece.reference_sign[c];
      Place& of = places_[row * size_ + column];
      (piece.transposed ? of.mirrored : of.direct) = frf;
    }
  }
}

/// The group of a file whose references have something in common, or one more.
std::size_t FrfCovariances::group_of(std::size_t source) {
  if (system_.source(source).has_reference_correlation()) {
    const auto of_source = [&](const std::vector<std::size_t>& group) { return columns_[group.front()].source == source; };
    const auto found = std::ranges::find_if(groups_, of_source);
    if (found != groups_.end()) return static_cast<std::size_t>(found - groups_.begin());
  }
  groups_.emplace_back();
  return groups_.size() - 1;
}

FrfCovariances::StoredFrf FrfCovariances::stored(std::size_t source, std::size_t response, std::size_t reference, bool by_law) {
  const auto found =
      std::ranges::find_if(columns_, [&](const Column& c) { return c.source == source && c.reference == reference; });
  const auto column = static_cast<std::size_t>(found - columns_.begin());
  if (found == columns_.end()) {
    std::vector<std::size_t>& group = groups_[group_of(source)];
    columns_.push_back(
        {source, reference, group.empty() ? std::vector<std::size_t>() : columns_[group.front()].responses, by_law, {}});
    group.push_back(column);
  }
  const auto group = std::ranges::find_if(groups_, [&](const auto& of) { return std::ranges::find(of, column) != of.end(); });
  const auto place = static_cast<std::size_t>(std::ranges::find(*group, column) - group->begin());
  const std::vector<std::size_t>& responses = columns_[column].responses;
  const auto member = static_cast<std::size_t>(std::ranges::find(responses, response) - responses.begin());
  if (member == responses.size()) {
    for (const std::size_t one : *group) columns_[one].responses.push_back(response);
  }
  return {static_cast<std::size_t>(group - groups_.begin()), place, member};
}

std::vector<std::size_t> FrfCovariances::source_lines(std::size_t source, std::span<const std::size_t> lines) const {
  std::vector<std::size_t> out;
  for (const std::size_t line : lines) out.push_back(system_.source_line(source, line));
  return out;
}

void FrfCovariances::prepare(std::span<const std::size_t> lines) {
  const std::size_t step = (lines.size() + most_samples - 1) / most_samples;
  std::vector<std::size_t> some;
  for (std::size_t i = 0; i < lines.size(); i += step) some.push_back(lines[i]);
  for (Column& column : columns_) {
    if (!column.by_law) continue;
    frf::FrfSource& source = system_.source(column.source);
    const std::vector<std::size_t> at_lines = source_lines(column.source, some);
    const StoredGroup stored = read_stored(source, column.responses, column.reference, at_lines);
    std::vector<CovarianceSample> samples;
    for (std::size_t i = 0; i < at_lines.size(); ++i) samples.push_back(sample_of(stored, i, source.header(), at_lines[i]));
    column.law = law_of(samples, source.header(), column.responses.size());
  }
}

/// Of the columns of a group whose references have this correlation (frf::FrfSet::reference_correlation).
MatrixXcd FrfCovariances::joined(const std::vector<std::size_t>& group, std::span<const Complex> correlation,
                                 const std::vector<MatrixXcd>& of_column) const {
  const Eigen::Index rows = at(columns_[group.front()].responses.size());
  const std::size_t size = group.size();
  std::vector<MatrixXcd> factors;
  for (const MatrixXcd& covariance : of_column) factors.push_back(dense::semidefinite_cholesky(covariance));
  MatrixXcd out(rows * at(size), rows * at(size));
  for (std::size_t m = 0; m < size; ++m) {
    for (std::size_t n = 0; n < size; ++n) {
      const Complex shared = correlation[m * size + n];
      auto block = out.block(rows * at(m), rows * at(n), rows, rows);
      if (m == n) {
        block = of_column[m];
      } else if (std::isfinite(shared.real())) {
        block = shared * (factors[m] * factors[n].adjoint());
      } else {
        block.setZero();
      }
    }
  }
  return out;
}

void FrfCovariances::read(std::span<const std::size_t> lines) {
  covariances_.assign(lines.size(), {});
  measured_.assign(lines.size(), {});
  for (const std::vector<std::size_t>& group : groups_) {
    const std::size_t from = columns_[group.front()].source;
    frf::FrfSource& source = system_.source(from);
    const std::vector<std::size_t> at_lines = source_lines(from, lines);
    std::vector<std::vector<MatrixXcd>> of_line(lines.size());
    std::vector<std::vector<bool>> measured(lines.size());
    std::vector<std::size_t> references;
    for (const std::size_t k : group) {
      const Column& column = columns_[k];
      references.push_back(column.reference);
      const StoredGroup stored = read_stored(source, column.responses, column.reference, at_lines);
      for (std::size_t i = 0; i < lines.size(); ++i) {
        const VectorXcd frf = stored.frf(i);
        MatrixXcd covariance = stored.covariance(i);
        if (column.law.constant.size() > 0) {
          const double factor = frf::squared_factor(source.header().quantity, source.header().frequency_hz[at_lines[i]]);
          covariance = column.law(frf, factor);
        } else {
          shrink(covariance, freedom_of(source.header()));
        }
        for (const Complex& value : frf) measured[i].push_back(!std::isnan(value.real()));
        of_line[i].push_back(std::move(covariance));
      }
    }
    const std::size_t squared = group.size() * group.size();
    std::vector<Complex> correlation(group.size() > 1 ? lines.size() * squared : 0);
    if (!correlation.empty()) source.read_reference_correlation(at_lines, references, correlation);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      covariances_[i].push_back(correlation.empty()
                                    ? std::move(of_line[i].front())
                                    : joined(group, std::span(correlation).subspan(i * squared, squared), of_line[i]));
      measured_[i].push_back(std::move(measured[i]));
    }
  }
}

StoredError FrfCovariances::error(std::size_t i, std::size_t row, std::size_t column) const {
  const Place& place = places_[row * size_ + column];
  const auto in_group = [&](const StoredFrf& frf) {
    if (frf.group == StoredError::none) return StoredError{};
    return StoredError{frf.group, frf.column * columns_[groups_[frf.group].front()].responses.size() + frf.member, frf.sign};
  };
  const StoredError direct = in_group(place.direct);
  return direct.is_known() && measured_[i][direct.group][direct.member] ? direct : in_group(place.mirrored);
}

}  // namespace jointid::ident

#include "study/recorded_noise.hpp"

#include <cmath>

#include "base/eigen.hpp"
#include "dense/cholesky.hpp"

namespace jointid::study {
namespace {

/// Of one line and reference, from the pairs of a set.
minimise::Correlation correlation_at(const frf::FrfSet& set, std::size_t line, std::size_t c) {
  const std::size_t rows = set.header.response.size(), columns = set.header.reference.size(), pairs = frf::pair_count(rows);
  const auto pair = [&](std::size_t r, std::size_t s) { return set.covariance[(line * pairs + frf::pair_index(r, s)) * columns + c]; };
  std::vector<std::size_t> known;
  for (std::size_t r = 0; r < rows; ++r) {
    if (pair(r, r).real() > 0.0) known.push_back(r);
  }
  Eigen::MatrixXcd covariance(at(known.size()), at(known.size()));
  for (std::size_t i = 0; i < known.size(); ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      const Complex value = pair(known[i], known[k]);
      covariance(at(i), at(k)) = std::isfinite(value.real()) ? value : Complex(0.0);
      covariance(at(k), at(i)) = std::conj(covariance(at(i), at(k)));
    }
  }
  return minimise::Correlation::of(rows, known, covariance, covariance.diagonal().real());
}

/// Lower W of ρ = W Wᴴ; the identity where it is not known.
Eigen::MatrixXcd between_references(const frf::FrfSet& set, std::size_t line) {
  const auto columns = at(set.header.reference.size());
  const Complex* of = set.reference_correlation.data() + static_cast<Eigen::Index>(line) * columns * columns;
  const Eigen::MatrixXcd correlation = Eigen::Map<const Eigen::MatrixXcd>(of, columns, columns).transpose();
  if (!correlation.allFinite()) return Eigen::MatrixXcd::Identity(columns, columns);
  return dense::semidefinite_cholesky(correlation);
}

}  // namespace

std::vector<Complex> covariance_of(frf::FrfSource& source, const frf::Block& block) {
  if (!source.has_covariance()) return {};
  const std::size_t rows = block.responses.size(), columns = block.references.size(), pairs = frf::pair_count(rows);
  std::vector<Complex> whole(block.size() * rows), out(block.lines.size() * pairs * columns);
  source.read_covariance(block, whole);
  for (std::size_t line = 0; line < block.lines.size(); ++line) {
    for (std::size_t c = 0; c < columns; ++c) {
      for (std::size_t r = 0; r < rows; ++r) {
        for (std::size_t s = 0; s <= r; ++s) {
          out[(line * pairs + frf::pair_index(r, s)) * columns + c] = whole[((line * columns + c) * rows + r) * rows + s];
        }
      }
    }
  }
  return out;
}

RecordedNoise::RecordedNoise(const frf::Excerpt& clean)
    : line_start_(clean.line_start),
      entry_(clean.entry),
      responses_(clean.set.header.response.size()),
      references_(clean.set.header.reference.size()) {
  const auto root = [](double variance) { return variance > 0.0 ? std::sqrt(variance) : 0.0; };
  for (const Complex& variance : clean.set.variance) deviation_.emplace_back(root(variance.real()), root(variance.imag()));
  if (clean.set.covariance.empty()) return;
  for (std::size_t line = 0; line < line_start_.size(); ++line) {
    for (std::size_t c = 0; c < references_; ++c) correlations_.push_back(correlation_at(clean.set, line, c));
    if (!clean.set.reference_correlation.empty()) between_.push_back(between_references(clean.set, line));
  }
}

void RecordedNoise::pollute(frf::FrfSet& set, const RandomStream& stream) const {
  std::vector<Complex> errors(responses_);
  for (std::size_t line = 0; line < line_start_.size(); ++line) {
    for (std::size_t c = 0; c < references_; ++c) {
      for (std::size_t r = 0; r < responses_; ++r) {
        const auto independent = [&](std::size_t reference) {
          const auto normal = normal_numbers(stream, line_start_[line] + entry_[r * references_ + reference]);
          return Complex(normal[0], normal[1]);
        };
        if (between_.empty()) {
          errors[r] = independent(c);
          continue;
        }
        errors[r] = 0.0;
        for (std::size_t n = 0; n <= c; ++n) errors[r] += between_[line](at(c), at(n)) * independent(n);
      }
      if (!correlations_.empty()) correlations_[line * references_ + c].colour(errors);
      for (std::size_t r = 0; r < responses_; ++r) {
        const std::size_t to = set.index(line, r, c);
        set.values[to] += Complex(deviation_[to].real() * errors[r].real(), deviation_[to].imag() * errors[r].imag());
      }
    }
  }
}

}  // namespace jointid::study

#include "virtualpoint/measured_errors.hpp"

#include <algorithm>
#include <cmath>

#include "frf/set/h1.hpp"
#include "virtualpoint/mixture.hpp"

namespace jointid::virtualpoint {

MeasuredErrors::MeasuredErrors(frf::FrfSource& source, const std::optional<frf::NoiseModel>& law) : source_(source), model_(law) {
  const frf::FrfHeader& header = source.header();
  if (header.noise == frf::NoiseRecord::variance) {
    origin_ = Origin::variance;
  } else if (header.noise == frf::NoiseRecord::coherence && header.averages >= 2.0) {
    origin_ = Origin::coherence;
  } else if (law) {
    origin_ = Origin::law;
  }
}

void MeasuredErrors::find_mean_squares() {
  const frf::FrfHeader& header = source_.header();
  const std::vector<std::size_t> responses = first_indices(header.response.size()),
                                 references = first_indices(header.reference.size());
  mean_squares_.assign(header.entries(), 0.0);
  std::vector<double> counts(header.entries(), 0.0);
  std::vector<Complex> values(header.entries());
  for (std::size_t line = 0; line < header.lines(); ++line) {
    source_.read({std::span(&line, 1), responses, references}, values);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double square = std::norm(values[i]) / frf::squared_factor(header.quantity, header.frequency_hz[line]);
      if (!std::isfinite(square)) continue;
      mean_squares_[i] += square;
      counts[i] += 1.0;
    }
  }
  for (std::size_t i = 0; i < counts.size(); ++i) mean_squares_[i] /= std::max(1.0, counts[i]);
}

void MeasuredErrors::read_variance(const frf::Block& block, std::span<Complex> out) {
  if (origin_ == Origin::variance) return source_.read_variance(block, out);
  const frf::FrfHeader& header = source_.header();
  source_.read(block, out);
  std::vector<double> coherence;
  if (origin_ == Origin::coherence) {
    coherence.resize(out.size());
    source_.read_coherence(block, coherence);
  } else if (model_->floor > 0.0 && mean_squares_.empty()) {
    find_mean_squares();
  }
  std::size_t next = 0;
  for (const std::size_t line : block.lines) {
    const double factor = frf::squared_factor(header.quantity, header.frequency_hz[line]);
    for (const std::size_t r : block.responses) {
      for (const std::size_t c : block.references) {
        Complex& value = out[next];
        if (origin_ == Origin::coherence) {
          value = frf::h1_part_variances(value, coherence[next], header.averages);
        } else {
          const double square = mean_squares_.empty() ? 0.0 : mean_squares_[r * header.reference.size() + c];
          value = frf::variance_law(*model_, square)(value, factor);
        }
        ++next;
      }
    }
  }
}

void MeasuredErrors::read_covariance(const frf::Block& block, std::span<Complex> out) {
  if (origin_ == Origin::variance && source_.has_covariance()) return source_.read_covariance(block, out);
  std::vector<Complex> variances(block.size());
  read_variance(block, variances);
  std::fill(out.begin(), out.end(), Complex(0.0));
  const std::size_t rows = block.responses.size(), columns = block.references.size();
  for (std::size_t i = 0; i < variances.size(); ++i) {
    const std::size_t line = i / (rows * columns), r = i / columns % rows, c = i % columns;
    out[((line * columns + c) * rows + r) * rows + r] = variances[i].real() + variances[i].imag();
  }
}

}  // namespace jointid::virtualpoint

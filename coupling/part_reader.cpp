#include "coupling/part_reader.hpp"

#include <cmath>

#include "base/eigen.hpp"
#include "base/error.hpp"
#include "frf/noise/variance_law.hpp"
#include "frf/set/h1.hpp"

namespace jointid::coupling {
namespace {

[[noreturn]] void fail(const std::string& file, std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::data,
                    .file = file,
                    .place = "variances",
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

void require_variance(const frf::FrfHeader& header, bool law) {
  if (header.noise == frf::NoiseRecord::variance) return;
  if (header.noise == frf::NoiseRecord::coherence) {
    if (header.averages >= 2.0) return;
    fail(header.file, "its coherences come from " + std::to_string(header.averages) + " averages",
         "coherences give the noise from two averages on");
  }
  if (!law) fail(header.file, "it has neither variances nor coherences", "give the noise in [noise]");
}

}  // namespace

PartReader::PartReader(const Part& part, std::vector<frf::Dof> rows, std::vector<frf::Dof> columns, bool variance,
                       const std::optional<frf::NoiseModel>& noise)
    : system_(part.system),
      rows_(std::move(rows)),
      columns_(std::move(columns)),
      reader_(*system_, rows_, columns_),
      noise_(noise) {
  if (!variance) return;
  pieces_ = system_->pieces(rows_, columns_);
  for (const frf::BlockPiece& piece : pieces_) require_variance(system_->source(piece.source).header(), noise_.has_value());
}

void PartReader::read(std::span<const std::size_t> lines, std::span<Complex> out) { reader_.read(lines, out); }

void PartReader::read_piece(const frf::BlockPiece& piece, std::span<const std::size_t> lines, std::vector<Complex>& values,
                            std::vector<Complex>& variances) {
  std::vector<std::size_t> source_lines;
  for (const std::size_t line : lines) source_lines.push_back(system_->source_line(piece.source, line));
  const frf::Block block{source_lines, piece.responses, piece.references};
  frf::FrfSource& source = system_->source(piece.source);
  values.resize(block.size());
  variances.resize(block.size());
  source.read(block, values);
  if (source.header().noise == frf::NoiseRecord::variance) {
    source.read_variance(block, variances);
    return;
  }
  if (source.header().noise == frf::NoiseRecord::coherence) {
    std::vector<double> coherence(block.size());
    source.read_coherence(block, coherence);
    for (std::size_t i = 0; i < values.size(); ++i) {
      variances[i] = frf::h1_part_variances(values[i], coherence[i], source.header().averages);
    }
    return;
  }
  const frf::VarianceLaw law = frf::variance_law(*noise_, 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) variances[i] = law(values[i], 0.0);
}

void PartReader::read_variance(std::span<const std::size_t> lines, std::span<Complex> out) {
  // As BlockReader fills: files first, then with reciprocity what is still missing from their transposes.
  const std::vector<Complex> background = system_->background(rows_, columns_);
  std::vector<Complex> values, variances;
  std::vector<bool> taken(out.size(), false);
  for (std::size_t line = 0; line < lines.size(); ++line) {
    std::copy(background.begin(), background.end(), out.begin() + static_cast<std::ptrdiff_t>(line * background.size()));
  }
  for (const frf::BlockPiece& piece : pieces_) {
    read_piece(piece, lines, values, variances);
    std::size_t from = 0;
    for (std::size_t line = 0; line < lines.size(); ++line) {
      for (std::size_t r = 0; r < piece.responses.size(); ++r) {
        for (std::size_t c = 0; c < piece.references.size(); ++c, ++from) {
          const std::size_t to = line * size() + piece.place(r, c, columns_.size());
          if (taken[to] || std::isnan(values[from].real())) continue;
          out[to] = variances[from];
          taken[to] = true;
        }
      }
    }
  }
}

bool PartReader::has_covariance() const {
  bool any = false;
  for (const frf::BlockPiece& piece : pieces_) {
    if (piece.transposed) return false;
    const frf::FrfSource& source = system_->source(piece.source);
    any = any || (source.header().noise == frf::NoiseRecord::variance && source.has_covariance());
  }
  return any;
}

double PartReader::covariance_freedom() const {
  double least = 0.0;
  for (const frf::BlockPiece& piece : pieces_) {
    const frf::FrfSource& source = system_->source(piece.source);
    if (!source.has_covariance()) continue;
    const frf::FrfHeader& header = source.header();
    const double freedom = header.repeats > 1 ? static_cast<double>(header.repeats - 1) : header.averages - 1.0;
    if (freedom > 0.0 && (least == 0.0 || freedom < least)) least = freedom;
  }
  return least;
}

std::vector<SharedColumns> PartReader::shared_columns(std::size_t line) {
  std::vector<SharedColumns> out;
  for (const frf::BlockPiece& piece : pieces_) {
    frf::FrfSource& source = system_->source(piece.source);
    if (!source.has_reference_correlation() || piece.references.size() < 2) continue;
    const std::size_t size = piece.references.size(), own = system_->source_line(piece.source, line);
    std::vector<Complex> correlation(size * size);
    source.read_reference_correlation(std::span(&own, 1), piece.references, correlation);
    SharedColumns shared{{}, {}, ComplexMatrix(at(size), at(size))};
    for (const std::size_t row : piece.rows) shared.rows.push_back(at(row));
    for (const std::size_t column : piece.columns) shared.columns.push_back(at(column));
    for (std::size_t m = 0; m < size; ++m) {
      for (std::size_t n = 0; n < size; ++n) {
        shared.correlation(at(m), at(n)) = piece.reference_sign[m] * piece.reference_sign[n] * correlation[m * size + n];
      }
    }
    if (shared.correlation.allFinite()) out.push_back(std::move(shared));
  }
  return out;
}

void PartReader::read_covariance(std::span<const std::size_t> lines, std::span<Complex> out) {
  const std::size_t rows = rows_.size(), columns = columns_.size();
  std::fill(out.begin(), out.end(), Complex(0.0));
  std::vector<Complex> covariance;
  for (const frf::BlockPiece& piece : pieces_) {
    frf::FrfSource& source = system_->source(piece.source);
    if (!source.has_covariance()) continue;
    std::vector<std::size_t> source_lines;
    for (const std::size_t line : lines) source_lines.push_back(system_->source_line(piece.source, line));
    const std::size_t some = piece.responses.size();
    covariance.resize(piece.size() * some * lines.size());
    source.read_covariance({source_lines, piece.responses, piece.references}, covariance);
    std::size_t from = 0;
    for (std::size_t line = 0; line < lines.size(); ++line) {
      for (const std::size_t column : piece.columns) {
        for (std::size_t r = 0; r < some; ++r) {
          for (std::size_t s = 0; s < some; ++s, ++from) {
            const Complex value = piece.response_sign[r] * piece.response_sign[s] * covariance[from];
            if (!std::isfinite(value.real())) continue;
            out[((line * columns + column) * rows + piece.rows[r]) * rows + piece.rows[s]] = value;
          }
        }
      }
    }
  }
}

}  // namespace jointid::coupling

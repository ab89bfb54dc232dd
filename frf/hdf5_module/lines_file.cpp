#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <string>
#include <vector>

#include "frf/hdf5_module/files.hpp"
#include "frf/hdf5_module/hdf5_create.hpp"
#include "frf/hdf5_module/hdf5_object.hpp"
#include "frf/hdf5_module/hdf5_output.hpp"
#include "frf/set/line_scale.hpp"

namespace jointid::frf {
namespace {

using hdf5::Handle;

constexpr std::size_t chunk_bytes = std::size_t{512} << 10;

std::size_t choose_lines_per_chunk(const FrfHeader& header, std::size_t asked) {
  const std::size_t line_bytes = header.entries() * sizeof(Complex);
  const std::size_t lines = asked != 0 ? asked : (chunk_bytes + line_bytes / 2) / line_bytes;
  return std::clamp<std::size_t>(lines, 1, header.lines());
}

class Lines {
 public:
  Lines(const TemporaryFile& file, const FrfHeader& header, const Hdf5WriteOptions& options)
      : output_(file),
        header_(header),
        quantity_(options.quantity.value_or(header.quantity)),
        lines_per_chunk_(choose_lines_per_chunk(header, options.lines_per_chunk)),
        with_covariance_(options.covariance),
        factor_(options.factor),
        with_reference_correlation_(options.reference_correlation),
        provenance_(options.provenance),
        written_(header.lines(), false) {
    output_.require(write_header() && create_datasets(options.compression));
  }

  std::size_t lines_per_chunk() const { return lines_per_chunk_; }

  void write_lines(std::size_t first, std::size_t count, std::span<const Complex> values,
                   std::span<const Complex> variance, std::span<const double> coherence, const CovarianceLines& covariance) {
    assert(first + count <= header_.lines() && values.size() == count * header_.entries());
    assert(variance.size() == (header_.noise == NoiseRecord::variance ? values.size() : 0));
    assert(coherence.size() == (header_.noise == NoiseRecord::coherence ? values.size() : 0));
    assert(covariance.pairs.size() == (with_covariance_ && factor_.rank == 0 ? count * pairs() * header_.reference.size() : 0));
    assert(covariance.rows.size() == (with_covariance_ ? values.size() * factor_.rank : 0));
    assert(covariance.diagonal.size() == (with_covariance_ && factor_.diagonal ? values.size() : 0));
    const std::size_t rows = header_.response.size(), references = header_.reference.size();
    assert(covariance.reference_correlation.size() == (with_reference_correlation_ ? count * references * references : 0));
    write_scaled(frf_, rows, first, count, values, [](const LineScale& s, Complex h) { return s.value(h); });
    if (!variance.empty()) {
      write_scaled(noise_, rows, first, count, variance, [](const LineScale& s, Complex v) { return s.variance(v); });
    }
    if (!covariance.pairs.empty()) {
      write_scaled(covariance_, pairs(), first, count, covariance.pairs,
                   [](const LineScale& s, Complex v) { return s.covariance(v); });
    }
    if (!covariance.rows.empty()) {
      write_scaled(covariance_, rows * factor_.rank, first, count, covariance.rows,
                   [](const LineScale& s, Complex v) { return s.factor(v); });
    }
    if (!covariance.reference_correlation.empty()) {
      output_.require(write_slab(reference_correlation_, hdf5::complex_type(), references, first, count,
                                 covariance.reference_correlation.data()));
    }
    if (!covariance.diagonal.empty()) write_diagonal(first, count, covariance.diagonal);
    if (!coherence.empty()) {
      output_.require(write_slab(noise_, Handle(H5Tcopy(H5T_NATIVE_DOUBLE)), rows, first, count, coherence.data()));
    }
    std::fill_n(written_.begin() + static_cast<std::ptrdiff_t>(first), count, true);
  }

  void finish() {
    const auto missing = std::find(written_.begin(), written_.end(), false);
    if (missing != written_.end()) {
      output_.fail("line " + std::to_string(missing - written_.begin() + 1) + " was never written");
    }
    const bool closed =
        frf_.close() && noise_.close() && covariance_.close() && diagonal_.close() && reference_correlation_.close();
    output_.finish(closed);
  }

 private:
  std::size_t pairs() const { return pair_count(header_.response.size()); }

  bool write_header() const {
    return hdf5::write_text_attribute(output_.file(), "format", "jointid-frf") &&
           hdf5::write_integer_attribute(output_.file(), "version", with_covariance_ ? 2 : 1) &&
           (provenance_.empty() || hdf5::write_text_attribute(output_.file(), "provenance", provenance_)) &&
           hdf5::write_axis(output_.file(), header_.frequency_hz) &&
           hdf5::write_dofs(output_.file(), "response_dof", header_.response) &&
           hdf5::write_dofs(output_.file(), "reference_dof", header_.reference) &&
           hdf5::write_nodes(output_.file(), header_.nodes);
  }

  bool create_datasets(int compression) {
    const std::array<std::size_t, 3> dims = {header_.lines(), header_.response.size(),
                                             header_.reference.size()};
    const Handle complex = hdf5::complex_type();
    const Handle real(H5Tcopy(H5T_NATIVE_DOUBLE));
    frf_ = hdf5::create_lines(output_.file(), "frf", complex, dims, lines_per_chunk_, compression);
    bool ok = frf_.is_open() && hdf5::write_text_attribute(frf_, "quantity", name(quantity_)) &&
              hdf5::write_text_attribute(frf_, "unit", unit(quantity_));
    if (ok && header_.noise == NoiseRecord::variance) {
      noise_ = hdf5::create_lines(output_.file(), "variance", complex, dims, lines_per_chunk_, compression);
      ok = noise_.is_open() && write_averages();
    } else if (ok && header_.noise == NoiseRecord::coherence) {
      noise_ = hdf5::create_lines(output_.file(), "coherence", real, dims, lines_per_chunk_, compression);
      ok = noise_.is_open() && write_averages();
    }
    if (ok && with_covariance_) {
      const bool factor = factor_.rank > 0;
      covariance_ = hdf5::create_lines(output_.file(), factor ? "covariance_factor" : "covariance", complex,
                                       {dims[0], factor ? dims[1] * factor_.rank : pairs(), dims[2]}, lines_per_chunk_, compression);
      ok = covariance_.is_open();
    }
    if (ok && with_covariance_ && factor_.diagonal) {
      diagonal_ = hdf5::create_lines(output_.file(), "covariance_diagonal", real, dims, lines_per_chunk_, compression);
      ok = diagonal_.is_open();
    }
    if (ok && with_reference_correlation_) {
      reference_correlation_ = hdf5::create_lines(output_.file(), "reference_correlation", complex, {dims[0], dims[2], dims[2]},
                                                  lines_per_chunk_, compression);
      ok = reference_correlation_.is_open();
    }
    return ok;
  }

  bool write_averages() { return header_.averages == 0.0 || hdf5::write_number_attribute(noise_, "averages", header_.averages); }

  /// Writes receptances, their variances or covariances, `rows` × references a line, in the stored quantity; `scale(line scale, value)`
  /// converts one.
  template <class Scale>
  void write_scaled(const Handle& dataset, std::size_t rows, std::size_t first, std::size_t count,
                    std::span<const Complex> values, Scale scale) {
    const Complex* data = values.data();
    if (quantity_ != Quantity::receptance) {
      scaled_.clear();
      for (std::size_t line = 0; line < count; ++line) {
        const LineScale of_line = LineScale::from_receptance(quantity_, header_.frequency_hz[first + line]);
        const std::size_t entries = rows * header_.reference.size();
        for (const Complex& value : values.subspan(line * entries, entries)) {
          scaled_.push_back(scale(of_line, value));
        }
      }
      data = scaled_.data();
    }
    output_.require(write_slab(dataset, hdf5::complex_type(), rows, first, count, data));
  }

  void write_diagonal(std::size_t first, std::size_t count, std::span<const double> diagonal) {
    std::vector<double> stored;
    stored.reserve(diagonal.size());
    for (std::size_t line = 0; line < count; ++line) {
      const LineScale of_line = LineScale::from_receptance(quantity_, header_.frequency_hz[first + line]);
      for (const double d : diagonal.subspan(line * header_.entries(), header_.entries())) stored.push_back(of_line.diagonal(d));
    }
    output_.require(write_slab(diagonal_, Handle(H5Tcopy(H5T_NATIVE_DOUBLE)), header_.response.size(), first, count, stored.data()));
  }

  bool write_slab(const Handle& dataset, const Handle& type, std::size_t rows, std::size_t first, std::size_t count,
                  const void* data) const {
    const std::array<hsize_t, 3> start = {first, 0, 0};
    const std::array<hsize_t, 3> extent = {count, rows, header_.reference.size()};
    const Handle in_file(H5Dget_space(dataset.get()));
    const Handle in_memory(H5Screate_simple(3, extent.data(), nullptr));
    return H5Sselect_hyperslab(in_file.get(), H5S_SELECT_SET, start.data(), nullptr, extent.data(),
                               nullptr) >= 0 &&
           H5Dwrite(dataset.get(), type.get(), in_memory.get(), in_file.get(), H5P_DEFAULT, data) >= 0;
  }

  hdf5::Output output_;
  FrfHeader header_;
  Quantity quantity_;
  std::size_t lines_per_chunk_;
  bool with_covariance_;
  FactorShape factor_;
  bool with_reference_correlation_;
  std::string provenance_;
  std::vector<bool> written_;
  Handle frf_;
  Handle noise_;
  Handle covariance_;  ///< pairs, or rows of the factor
  Handle diagonal_;
  Handle reference_correlation_;
  std::vector<Complex> scaled_;
};

class LinesFile final : public LinesOutput {
 public:
  LinesFile(const TemporaryFile& file, const FrfHeader& header, const Hdf5WriteOptions& options) {
    const hdf5::Silence silence;
    lines_.emplace(file, header, options);
  }

  ~LinesFile() override {
    const hdf5::Silence silence;
    lines_.reset();
  }

  std::size_t lines_per_chunk() const override { return lines_->lines_per_chunk(); }

  void write_lines(std::size_t first, std::size_t count, std::span<const Complex> values, std::span<const Complex> variance,
                   std::span<const double> coherence, const CovarianceLines& covariance) override {
    const hdf5::Silence silence;
    lines_->write_lines(first, count, values, variance, coherence, covariance);
  }

  void finish() override {
    const hdf5::Silence silence;
    lines_->finish();
  }

 private:
  std::optional<Lines> lines_;
};

}  // namespace

std::unique_ptr<LinesOutput> hdf5::create_lines_file(const TemporaryFile& file, const FrfHeader& header,
                                                     const Hdf5WriteOptions& options) {
  return std::make_unique<LinesFile>(file, header, options);
}

}  // namespace jointid::frf

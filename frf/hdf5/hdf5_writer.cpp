#include "frf/hdf5/hdf5_writer.hpp"

#include "base/error.hpp"
#include "frf/hdf5/file_origin.hpp"
#include "frf/set/frf_source.hpp"

namespace jointid::frf {
namespace {

void validate(const Hdf5WriteOptions& options) {
  if (options.compression >= 0 && options.compression <= 9) return;
  throw InputError({.kind = ErrorKind::usage,
                    .file = {},
                    .place = "compression",
                    .problem = std::to_string(options.compression) + " is not a deflate level",
                    .remedy = "use 0 to 9"});
}

Hdf5WriteOptions with_origin(Hdf5WriteOptions options) {
  if (options.provenance.empty()) options.provenance = file_origin();
  return options;
}

}  // namespace

Hdf5Writer::Hdf5Writer(const std::filesystem::path& path, const FrfHeader& header, const Hdf5WriteOptions& options)
    : temporary_((validate(header), validate(options), path)), file_(hdf5_module().create(temporary_, header, with_origin(options))) {}

void Hdf5Writer::write_lines(std::size_t first, std::size_t count, std::span<const Complex> values,
                             std::span<const Complex> variance, std::span<const double> coherence,
                             const CovarianceLines& covariance) {
  if (count > 0) file_->write_lines(first, count, values, variance, coherence, covariance);
}

void Hdf5Writer::finish() {
  file_->finish();
  temporary_.commit();
}

std::size_t Hdf5Writer::lines_per_chunk() const { return file_->lines_per_chunk(); }

void write_hdf5(const FrfSet& set, const std::filesystem::path& path, const Hdf5WriteOptions& options) {
  Hdf5WriteOptions with = options;
  with.covariance = set.has_covariance();
  const bool factor = set.factor.shape().is_smaller(set.header.response.size());
  with.factor = factor ? set.factor.shape() : FactorShape{};
  with.reference_correlation = !set.reference_correlation.empty();
  const std::vector<Complex> pairs = factor ? std::vector<Complex>() : covariance_pairs(set);
  Hdf5Writer writer(path, set.header, with);
  writer.write_lines(0, set.header.lines(), set.values, set.variance, set.coherence,
                     factor ? CovarianceLines{{}, set.factor.rows, set.factor.diagonal, set.reference_correlation}
                            : CovarianceLines{pairs, {}, {}, set.reference_correlation});
  writer.finish();
}

}  // namespace jointid::frf

#include "tasks/convert/convert.hpp"

#include <vector>

#include "frf/file/write.hpp"
#include "frf/hdf5/hdf5_writer.hpp"
#include "tasks/convert/line_pieces.hpp"

namespace jointid::tasks {
namespace {

/// Line by line, so that a file larger than the memory passes. False, and no file, when interrupted.
bool stream_to_hdf5(frf::FrfSource& source, const std::filesystem::path& path, const ident::Control& control,
                    frf::TurnedPoints* turned) {
  const frf::FrfHeader& header = source.header();
  const frf::FactorShape stored = source.factor_shape();
  const frf::FactorShape shape = stored.is_smaller(header.response.size()) ? stored : frf::FactorShape{};
  frf::Hdf5Writer writer(
      path, header,
      {.covariance = source.has_covariance(), .factor = shape, .reference_correlation = source.has_reference_correlation()});
  std::vector<Complex> values, variance, pairs, rows, correlation;
  std::vector<double> coherence, diagonal;
  const bool complete = for_each_piece(header, writer.lines_per_chunk(), [&](const frf::Block& block) {
    values.resize(block.size());
    source.read(block, values);
    if (turned != nullptr) turned->add(values);
    if (header.noise == frf::NoiseRecord::variance) {
      variance.resize(block.size());
      source.read_variance(block, variance);
    }
    if (header.noise == frf::NoiseRecord::coherence) {
      coherence.resize(block.size());
      source.read_coherence(block, coherence);
    }
    if (shape.rank > 0) {
      rows.resize(block.size() * shape.rank);
      diagonal.resize(shape.diagonal ? block.size() : 0);
      source.read_factor(block, rows, diagonal);
    } else if (source.has_covariance()) {
      pairs.resize(block.lines.size() * frf::pair_count(header.response.size()) * header.reference.size());
      source.read_covariance_pairs(block.lines, pairs);
    }
    if (source.has_reference_correlation()) {
      correlation.resize(block.lines.size() * header.reference.size() * header.reference.size());
      source.read_reference_correlation(block.lines, block.references, correlation);
    }
    if (control.progress) control.progress("converting", block.lines.front(), header.lines());
    writer.write_lines(block.lines.front(), block.lines.size(), values, variance, coherence,
                       {pairs, rows, diagonal, correlation});
    return !(control.interrupted && control.interrupted());
  });
  if (complete) writer.finish();
  return complete;
}

}  // namespace

bool is_hdf5(const std::filesystem::path& path) { return path.extension() == ".h5" || path.extension() == ".hdf5"; }

bool convert(frf::FrfSource& source, const std::filesystem::path& path, const ident::Control& control, frf::TurnedPoints* turned) {
  if (is_hdf5(path)) return stream_to_hdf5(source, path, control, turned);
  if (control.progress) control.progress("converting", 0, 0);
  const frf::FrfSet set = frf::load(source);
  if (turned != nullptr) turned->add(set.values);
  frf::write(set, path);
  return true;
}

}  // namespace jointid::tasks

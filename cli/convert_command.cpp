#include <vector>

#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/line_pieces.hpp"
#include "cli/open_options.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "frf/hdf5_writer.hpp"
#include "frf/write.hpp"

namespace jointid::cli {
namespace {

using Path = std::filesystem::path;

bool is_hdf5(const Path& path) { return path.extension() == ".h5" || path.extension() == ".hdf5"; }

/// Line by line, so that a file larger than the memory passes. False, and no file, when interrupted.
bool stream_to_hdf5(frf::FrfSource& source, const Path& path) {
  const frf::FrfHeader& header = source.header();
  frf::Hdf5Writer writer(path, header);
  std::vector<Complex> values, variance;
  std::vector<double> coherence;
  Progress progress;
  const bool complete = for_each_piece(header, writer.lines_per_chunk(), [&](const frf::Block& block) {
    values.resize(block.size());
    source.read(block, values);
    if (header.noise == frf::NoiseRecord::variance) {
      variance.resize(block.size());
      source.read_variance(block, variance);
    }
    if (header.noise == frf::NoiseRecord::coherence) {
      coherence.resize(block.size());
      source.read_coherence(block, coherence);
    }
    progress.count("converting", block.lines.front(), header.lines());
    writer.write_lines(block.lines.front(), block.lines.size(), values, variance, coherence);
    return !interrupted();
  });
  if (complete) writer.finish();
  return complete;
}

}  // namespace

ExitCode execute(const ConvertArguments& arguments, std::ostream& out) {
  std::vector<ident::NamedFile> inputs;
  for (const auto& file : arguments.in) inputs.push_back({file, "IN"});
  check_targets(inputs, {{"OUT", arguments.out.string()}});
  const auto source = with_progress("reading", [&] { return open_as_one(arguments.in, arguments.open); });
  if (is_hdf5(arguments.out)) {
    if (!stream_to_hdf5(*source, arguments.out)) return ExitCode::interrupted;
  } else {
    with_progress("converting", [&] { frf::write(frf::load(*source), arguments.out); });
  }
  const frf::FrfHeader& header = source->header();
  out << "wrote " << arguments.out.string() << ": " << header.lines() << " lines, " << header.response.size() << " × "
      << header.reference.size() << " FRFs\n";
  return ExitCode::done;
}

}  // namespace jointid::cli

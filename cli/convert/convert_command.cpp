#include "cli/convert/convert_command.hpp"

#include <CLI/CLI.hpp>
#include <vector>

#include "cli/options/command_options.hpp"
#include "cli/options/open_options.hpp"
#include "cli/options/output.hpp"
#include "cli/text/interrupt.hpp"
#include "cli/text/line_pieces.hpp"
#include "cli/text/progress.hpp"
#include "frf/file/write.hpp"
#include "frf/hdf5/hdf5_writer.hpp"

namespace jointid::cli {
namespace {

using Path = std::filesystem::path;

bool is_hdf5(const Path& path) { return path.extension() == ".h5" || path.extension() == ".hdf5"; }

/// Line by line, so that a file larger than the memory passes. False, and no file, when interrupted.
bool stream_to_hdf5(frf::FrfSource& source, const Path& path) {
  const frf::FrfHeader& header = source.header();
  const frf::FactorShape stored = source.factor_shape();
  const frf::FactorShape shape = stored.is_smaller(header.response.size()) ? stored : frf::FactorShape{};
  frf::Hdf5Writer writer(
      path, header,
      {.covariance = source.has_covariance(), .factor = shape, .reference_correlation = source.has_reference_correlation()});
  std::vector<Complex> values, variance, pairs, rows, correlation;
  std::vector<double> coherence, diagonal;
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
    progress.count("converting", block.lines.front(), header.lines());
    writer.write_lines(block.lines.front(), block.lines.size(), values, variance, coherence,
                       {pairs, rows, diagonal, correlation});
    return !interrupted();
  });
  if (complete) writer.finish();
  return complete;
}

}  // namespace

void add_convert(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<ConvertArguments>(
      app, chosen, "convert", "Convert FRF files, several of one structure into one; the name of OUT gives the format");
  command
      ->add_option_function<std::vector<std::filesystem::path>>(
          "IN OUT",
          [to = arguments](const std::vector<std::filesystem::path>& files) {
            if (files.size() < 2) throw CLI::RequiredError("OUT");
            to->in = {files.begin(), files.end() - 1};
            to->out = files.back();
          },
          "Files to read: UFF, HDF5, MAT, numpy, CSV or text exports of an analyser; last the file to write")
      ->required();
  add_open_options(command, arguments->open);
  add_force(command);
  command->footer(
      "Examples:\n  jointid convert beam_long.uff beam_long.h5\n"
      "  jointid convert rig.mat rig.h5 --quantity accelerance --response 4:+Y,5:+Y\n"
      "  jointid convert hit_1.txt hit_3.txt beam.h5 --response 4:-X --reference 1:+X,3:+X");
}

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
      << header.reference.size() << " FRFs";
  if (source->has_covariance() && !is_hdf5(arguments.out)) out << ", without their covariances, which HDF5 alone holds";
  if (frf::any_own_axes(header.nodes) && !is_hdf5(arguments.out))
    out << ", without the axes of its nodes, which HDF5 alone holds";
  out << '\n';
  return ExitCode::done;
}

}  // namespace jointid::cli

#include <array>
#include <vector>

#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/line_pieces.hpp"
#include "frf/csv_file.hpp"
#include "frf/error.hpp"
#include "frf/hdf5_writer.hpp"
#include "frf/mat_file.hpp"
#include "frf/uff_file.hpp"

namespace jointid::cli {
namespace {

using Path = std::filesystem::path;

/// Line by line, so that a file larger than the memory passes. False, and no file, when interrupted.
bool to_hdf5(frf::FrfSource& source, const Path& path) {
  const frf::FrfHeader& header = source.header();
  frf::Hdf5Writer writer(path, header);
  std::vector<frf::Complex> values, variance;
  std::vector<double> coherence;
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
    writer.write_lines(block.lines.front(), block.lines.size(), values, variance, coherence);
    return !interrupted();
  });
  if (complete) writer.finish();
  return complete;
}

/// By way of a set in memory.
template <auto write>
bool whole(frf::FrfSource& source, const Path& path) {
  write(frf::load(source), path);
  return true;
}

void to_uff(const frf::FrfSet& set, const Path& path) {
  frf::write_uff(set, path, {.quantity = set.header.quantity});
}

struct Format {
  const char* extension;
  bool (*write)(frf::FrfSource& source, const Path& path);
};

constexpr std::array<Format, 6> formats = {{{".h5", to_hdf5},
                                            {".hdf5", to_hdf5},
                                            {".uff", whole<to_uff>},
                                            {".unv", whole<to_uff>},
                                            {".mat", whole<frf::write_mat>},
                                            {".csv", whole<frf::write_csv>}}};

const Format& format_of(const Path& path) {
  for (const Format& format : formats) {
    if (path.extension() == format.extension) return format;
  }
  throw InputError({ErrorKind::usage, path.string(), "",
                    "'" + path.extension().string() + "' names no format to write",
                    "end the name in .h5, .hdf5, .uff, .unv, .mat or .csv"});
}

}  // namespace

ExitCode execute(const ConvertArguments& arguments, std::ostream& out) {
  catch_interrupts();
  const Format& format = format_of(arguments.out);
  const auto source = frf::open(arguments.in, arguments.open);
  if (!format.write(*source, arguments.out)) return ExitCode::interrupted;
  const frf::FrfHeader& header = source->header();
  out << "wrote " << arguments.out.string() << ": " << header.lines() << " lines, " << header.response.size() << " × "
      << header.reference.size() << " FRFs\n";
  return ExitCode::done;
}

}  // namespace jointid::cli

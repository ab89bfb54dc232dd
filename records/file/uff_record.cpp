#include "records/file/uff_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/complex.hpp"
#include "frf/uff/uff58_data.hpp"
#include "records/file/limits.hpp"
#include "records/file/uff_channels.hpp"

namespace jointid::records {
namespace {

/// Adds the samples of a channel to a run, all of whose channels have one rate and length.
void add(frf::uff::ByteFile& file, const UffChannel& found, Record& run) {
  const frf::uff::Points points = frf::uff::read_points(file, found.dataset);
  Channel channel{found.name, found.dof, found.kind.value(), std::vector<double>(points.values.size())};
  std::ranges::transform(points.values, channel.samples.begin(), [&](Complex value) { return found.to_si * value.real(); });
  const double rate_hz = found.rate_hz(file.name(), points.abscissa);
  if (run.channels.empty()) run.rate_hz = rate_hz;
  if (!run.channels.empty() &&
      (run.samples() != channel.samples.size() || std::abs(rate_hz - run.rate_hz) > 1e-6 * run.rate_hz)) {
    found.dataset.place.fail("record 7",
                             fmt::format("{} samples at {:g} Hz, the channels before have {} at {:g} Hz", channel.samples.size(),
                                         rate_hz, run.samples(), run.rate_hz),
                             "export channels of one run with one rate and length");
  }
  run.channels.push_back(std::move(channel));
}

}  // namespace

std::vector<Record> read_uff_records(const std::filesystem::path& path) {
  frf::uff::ByteFile file(path);
  std::vector<Record> records;
  std::uint64_t numbers = 0;
  for (const std::vector<UffChannel>& run : uff_runs(file, UffQuantities::forces_and_motions)) {
    records.push_back({file.name(), 0.0});
    for (const UffChannel& channel : run) {
      numbers += channel.dataset.function->points;
      if (numbers > most_numbers)
        channel.dataset.place.fail("record 7", "the file holds more than 268 million numbers", "export it in several files");
      add(file, channel, records.back());
    }
  }
  return records;
}

}  // namespace jointid::records

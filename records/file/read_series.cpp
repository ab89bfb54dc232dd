#include "records/file/read_series.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "records/file/limits.hpp"
#include "records/file/open_samples.hpp"
#include "records/file/time_axis.hpp"

namespace jointid::records {
namespace {

constexpr std::size_t block_rows = 4096;

/// Appends the stream's samples to the columns; whether the stream has more than `most`.
bool take(SampleStream& stream, std::size_t most, std::vector<std::vector<double>>& columns) {
  const std::size_t width = columns.size();
  std::vector<double> rows(block_rows * width);
  for (std::size_t count = stream.read(rows); count > 0; count = stream.read(rows)) {
    if ((columns.front().size() + count) * width > most_numbers)
      throw InputError({ErrorKind::data, stream.file(), "", "holds more than 268 million numbers",
                        "name fewer channels, or take fewer samples"});
    for (std::size_t k = 0; k < width; ++k) {
      for (std::size_t i = 0; i < count; ++i) columns[k].push_back(rows[i * width + k]);
    }
    if (most == 0 || columns.front().size() <= most) continue;
    for (std::vector<double>& column : columns) column.resize(most);
    return true;
  }
  return false;
}

double rate_of_file(SampleStream& stream, const std::filesystem::path& path, const SeriesOptions& options) {
  if (!stream.time_column().empty()) {
    const auto times = open_samples(path, {{stream.time_column()}, 0, 1});
    std::vector<std::vector<double>> column(1);
    take(*times, options.most_samples, column);
    const auto& [name, unit] = times->channels().front();
    return stated_or_given_rate({name, unit, std::move(column.front())}, stream.file(), options.rate_hz);
  }
  if (const auto rate = stream.rate_hz(options.rate_hz)) return *rate;
  throw InputError(
      {ErrorKind::data, stream.file(), "", "does not state when its samples were taken", "give --rate HZ, or a column named time"});
}

}  // namespace

SeriesRecord read_series(const std::filesystem::path& path, const SeriesOptions& options) {
  const auto stream = open_samples(path, {options.channels, 0, 1});
  SeriesRecord out{stream->file(), 0.0, stream->channels(), {}, false};
  out.samples.resize(out.channels.size());
  out.is_cut = take(*stream, options.most_samples, out.samples);
  if (out.samples.front().empty()) throw InputError({ErrorKind::data, out.file, "", "has no samples", ""});
  if (!options.without_times) out.rate_hz = rate_of_file(*stream, path, options);
  return out;
}

}  // namespace jointid::records

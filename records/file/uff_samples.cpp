#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/temporary_file.hpp"
#include "frf/uff/uff58_data.hpp"
#include "records/file/channel_choice.hpp"
#include "records/file/sample_streams.hpp"
#include "records/file/uff_channels.hpp"

namespace jointid::records {
namespace {

std::vector<double> real_parts(const std::vector<std::complex<double>>& values) {
  std::vector<double> out(values.size());
  std::ranges::transform(values, out.begin(), [](const auto& value) { return value.real(); });
  return out;
}

class UffSamples final : public SampleStream {
 public:
  UffSamples(const std::filesystem::path& path, const StreamOptions& options)
      : SampleStream(path.string()), bytes_(path), spool_(file_) {
    const std::vector<std::vector<UffChannel>> runs = uff_runs(bytes_);
    frf::Columns titles{file_, {}};
    for (const UffChannel& channel : runs.front()) titles.columns.push_back({channel.name, channel.unit, {}});
    const std::vector<std::size_t> chosen = chosen_columns(titles, options.channels);
    for (const std::size_t k : chosen) channels_.push_back({titles.columns[k].name, titles.columns[k].unit});
    for (const std::vector<UffChannel>& run : runs) runs_.push_back(prepared(run, chosen, titles, options));
    first_ = runs.front()[chosen.front()];
  }

  std::optional<double> rate_hz(std::optional<double> given_hz) override {
    if (!first_.dataset.function->even) return given_hz;
    return first_.times(file_, {}, given_hz).rate_hz;
  }

  std::size_t read(std::span<double> rows) override {
    for (; run_ < runs_.size(); ++run_) {
      Run& run = runs_[run_];
      const std::size_t width = run.channels.size(), count = std::min(rows.size() / width, run.range.last - run.range.first);
      if (count == 0) continue;
      std::vector<double> values(count);
      for (std::size_t k = 0; k < width; ++k) {
        read(run.channels[k], run.range.first + run.channels[k].skipped, values);
        for (std::size_t i = 0; i < count; ++i) rows[i * width + k] = run.channels[k].channel.to_si * values[i];
      }
      run.range.first += count;
      return count;
    }
    return 0;
  }

 private:
  struct Stored {
    UffChannel channel;
    std::optional<std::size_t> spooled = {};  ///< of text: where its numbers begin in the spool
    std::size_t skipped = 0;                  ///< samples before all channels have begun
  };
  struct Run {
    std::vector<Stored> channels;
    SampleRange range;
  };

  /// The chosen channels of a run, which must be those of the first one.
  Run prepared(const std::vector<UffChannel>& run, const std::vector<std::size_t>& chosen, const frf::Columns& titles,
               const StreamOptions& options) {
    Run out;
    std::size_t shortest = static_cast<std::size_t>(-1);
    for (const std::size_t k : chosen) {
      const auto found = std::ranges::find_if(run, [&](const UffChannel& channel) {
        return channel.name == titles.columns[k].name && channel.unit == titles.columns[k].unit;
      });
      if (found == run.end()) {
        throw InputError({ErrorKind::data, file_, "",
                          fmt::format("channel {} [{}] is not in all runs", titles.columns[k].name, titles.columns[k].unit),
                          "name the channels that are"});
      }
      out.channels.push_back({*found});
    }
    skip_to_common_start(out);
    for (const Stored& stored : out.channels)
      shortest = std::min<std::size_t>(shortest, stored.channel.dataset.function->points - stored.skipped);
    for (Stored& stored : out.channels) {
      cut_ += stored.channel.dataset.function->points - stored.skipped - shortest;
      if (!stored.channel.dataset.binary)
        stored.spooled = spool_.put(real_parts(frf::uff::read_points(bytes_, stored.channel.dataset).values));
    }
    out.range = range_of(options, shortest);
    return out;
  }

  /// Leaves out whole samples of channels that begin before others, so that a row is an instant.
  void skip_to_common_start(Run& run) const {
    const auto first_of = [](const Stored& stored) { return stored.channel.dataset.function->abscissa_first; };
    const double last = first_of(*std::ranges::max_element(run.channels, {}, first_of));
    for (Stored& stored : run.channels) {
      const frf::uff::Header58& header = *stored.channel.dataset.function;
      if (first_of(stored) == last || !header.even) continue;
      constexpr double whole = 0.01;  // of a sample
      const double early = (last - first_of(stored)) / header.abscissa_step, samples = std::round(early);
      if (!(std::abs(early - samples) < whole) || !(samples < static_cast<double>(header.points))) {
        stored.channel.dataset.place.fail(
            "record 7",
            fmt::format("the channel begins at {:g}, another at {:g}: {:g} samples between them", first_of(stored), last, early),
            "name channels that begin together, or a whole number of samples apart, by --channels");
      }
      stored.skipped = static_cast<std::size_t>(samples);
    }
  }

  void read(const Stored& stored, std::size_t first, std::span<double> values) {
    if (stored.spooled) return spool_.get(*stored.spooled + first, values);
    const frf::uff::Points points = frf::uff::read_points(bytes_, stored.channel.dataset, first, values.size());
    std::ranges::transform(points.values, values.begin(), [](const auto& value) { return value.real(); });
  }

  frf::uff::ByteFile bytes_;
  UffChannel first_;   ///< of the chosen ones: its times are those of all
  NumberSpool spool_;  ///< the channels of text
  std::vector<Run> runs_;
  std::size_t run_ = 0;
};

}  // namespace

std::unique_ptr<SampleStream> open_uff_samples(const std::filesystem::path& path, const StreamOptions& options) {
  return std::make_unique<UffSamples>(path, options);
}

}  // namespace jointid::records

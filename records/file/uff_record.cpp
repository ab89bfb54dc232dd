#include "records/file/uff_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "frf/file/columns.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/uff/uff58_data.hpp"
#include "records/file/channel_choice.hpp"
#include "records/file/limits.hpp"
#include "records/file/stated_unit.hpp"
#include "records/file/uff_channels.hpp"

namespace jointid::records {
namespace {

/// A channel of a run, and what the user says of it, if anything.
struct Chosen {
  const UffChannel* channel = nullptr;
  const GivenChannel* given = nullptr;
};

std::vector<Chosen> chosen_of(const std::string& file, const std::vector<UffChannel>& run, const RecordOptions& options) {
  std::vector<Chosen> out;
  if (options.channels.empty()) {
    for (const UffChannel& channel : run) out.push_back({&channel, nullptr});
    return out;
  }
  frf::Columns titles{file, {}};
  for (const UffChannel& channel : run) titles.columns.push_back({channel.name, {}, {}});
  std::vector<std::string> names;
  for (const GivenChannel& given : options.channels) names.push_back(given.column);
  const std::vector<std::size_t> places = chosen_columns(titles, names);
  for (std::size_t i = 0; i < places.size(); ++i) out.push_back({&run[places[i]], &options.channels[i]});
  return out;
}

/// Where a channel stood: as its record says, else as it is given.
frf::Dof dof_of(const Chosen& chosen, bool any_dof) {
  const auto& [channel, given] = chosen;
  if (given != nullptr && (any_dof || !channel->dof)) return given->dof;
  if (!channel->dof) {
    channel->dataset.place.fail("record 6",
                                "response node " + std::to_string(channel->dataset.function->response.node) + " has no direction",
                                "give its place and unit, e.g. --channel '1=4:+Z m/s^2' (in a scene: channels)");
  }
  if (given != nullptr && given->dof != *channel->dof) {
    channel->dataset.place.fail(
        "record 6", "states " + channel->dof->name() + ", and " + given->dof.name() + " is given for " + given->column,
        "give the DOF that the file states, or correct the file");
  }
  return *channel->dof;
}

struct Scale {
  ChannelKind kind;
  double to_si;
};

Scale stated_scale(const UffChannel& channel, double factor) {
  if (channel.kind) return {*channel.kind, factor * channel.to_si};
  channel.dataset.place.fail(
      "record 9", channel.problem,
      "export displacement (8), velocity (11), acceleration (12) or force (13) with their units, or give unit "
      "and factor, e.g. --channel '1=4:+Z 0.981 m/s^2' (in a scene: channels)");
}

/// By a unit and a factor that are given, which must not contradict the record.
Scale given_scale(const std::string& file, const UffChannel& channel, const GivenUnit& given, const frf::Dof& dof) {
  const frf::uff::Place& place = channel.dataset.place;
  const auto unit = frf::parse_unit(given.unit);
  const auto kind = unit ? kind_of(*unit, dof.is_rotation()) : std::nullopt;
  if (!kind) place.fail("record 9", "'" + given.unit + "' is no unit of a force or a motion at " + dof.name(), "give N or m/s^2");
  if (!channel.kind) {
    require_agreement(channel.stated, given, file, place.dataset + ", record 9 of " + channel.name);
  } else if (channel.kind != kind || (!channel.stated.empty() && !agree(channel.to_si, unit->si, given.factor))) {
    place.fail("record 9 of " + channel.name,
               "states " + name(*channel.kind) + (channel.stated.empty() ? "" : " in " + channel.stated) + ", and " + given.unit +
                   " is given",
               "give the unit that the file states, or correct the file");
  }
  return {*kind, given.factor * unit->si};
}

/// What its numbers are: as the record says, else as it is given.
Scale scale_of(const std::string& file, const Chosen& chosen, const frf::Dof& dof, const std::string& otherwise) {
  const auto& [channel, given] = chosen;
  if (given == nullptr) return stated_scale(*channel, 1.0);
  if (!given->unit.empty()) return given_scale(file, *channel, {given->unit, given->factor}, dof);
  if (channel->kind || otherwise.empty()) return stated_scale(*channel, given->factor);
  return given_scale(file, *channel, {otherwise, given->factor}, dof);
}

/// Adds the samples of a channel to a run, all of whose channels have one rate and length.
void add(frf::uff::ByteFile& file, const Chosen& chosen, const RecordOptions& options, Record& run) {
  const UffChannel& found = *chosen.channel;
  const frf::Dof dof = dof_of(chosen, options.any_dof);
  const auto [kind, to_si] = scale_of(file.name(), chosen, dof, options.unit_otherwise);
  const frf::uff::Points points = frf::uff::read_points(file, found.dataset);
  Channel channel{found.name, dof, kind, std::vector<double>(points.values.size())};
  std::ranges::transform(points.values, channel.samples.begin(), [factor = to_si](Complex value) { return factor * value.real(); });
  const UffChannel::Times times = found.times(file.name(), points.abscissa, options.rate_hz);
  if (!times.rate_hz)
    found.dataset.place.fail("record 7", "states no step of the abscissa",
                             "give the samples per second by --rate (in a scene: rate)");
  channel.start_s = times.start_s;
  if (run.channels.empty()) run.rate_hz = *times.rate_hz;
  if (!run.channels.empty() &&
      (run.samples() != channel.samples.size() || std::abs(*times.rate_hz - run.rate_hz) > 1e-6 * run.rate_hz)) {
    found.dataset.place.fail("record 7",
                             fmt::format("{} samples at {:g} Hz, the channels before have {} at {:g} Hz", channel.samples.size(),
                                         *times.rate_hz, run.samples(), run.rate_hz),
                             "export channels of one run with one rate and length");
  }
  run.channels.push_back(std::move(channel));
}

/// Start times from that of the first channel on; those that differ by a millionth of a step are one.
void count_from_first(Record& run) {
  const double first = run.channels.front().start_s;
  for (Channel& channel : run.channels) {
    channel.start_s -= first;
    if (std::abs(channel.start_s) * run.rate_hz < 1e-6) channel.start_s = 0.0;
  }
}

}  // namespace

std::vector<Record> read_uff_records(const std::filesystem::path& path, const RecordOptions& options) {
  frf::uff::ByteFile file(path);
  if (!options.time.empty()) {
    throw InputError({ErrorKind::data,
                      file.name(),
                      {},
                      "a universal file has no column of times, its records state theirs",
                      "leave out --time (in a scene: time)"});
  }
  std::vector<Record> records;
  std::uint64_t numbers = 0;
  for (const std::vector<UffChannel>& run : uff_runs(file)) {
    records.push_back({file.name(), 0.0});
    for (const Chosen& chosen : chosen_of(file.name(), run, options)) {
      numbers += chosen.channel->dataset.function->points;
      if (numbers > most_numbers)
        chosen.channel->dataset.place.fail("record 7", "the file holds more than 268 million numbers",
                                           "export it in several files");
      add(file, chosen, options, records.back());
    }
    count_from_first(records.back());
  }
  return records;
}

}  // namespace jointid::records

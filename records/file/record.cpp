#include "records/file/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace jointid::records {
namespace {

/// Throws unless a record has the rate and the responses of the first.
void require_like(const Record& first, const Record& record) {
  const auto fail = [&](std::string problem) {
    throw InputError(
        {ErrorKind::data, record.file, {}, std::move(problem), "make the FRFs of such records apart from each other"});
  };
  if (std::abs(record.rate_hz - first.rate_hz) > 1e-6 * first.rate_hz) {
    fail(fmt::format("was sampled at {:.10g} Hz, {} at {:.10g} Hz", record.rate_hz, first.file, first.rate_hz));
  }
  const auto text = [](const Record& of) {
    std::string out;
    const std::vector<std::size_t> forces = force_channels(of);
    if (forces.size() > 1) {
      for (const std::size_t i : forces) out += " force " + of.channels[i].dof.name();
    }
    for (const std::size_t i : motion_channels(of)) out += " " + name(of.channels[i].kind) + " " + of.channels[i].dof.name();
    return out;
  };
  if (text(first) != text(record)) fail("has the channels" + text(record) + "; " + first.file + " has" + text(first));
}

}  // namespace

std::string name(ChannelKind kind) {
  switch (kind) {
    case ChannelKind::force:
      return "force";
    case ChannelKind::displacement:
      return "displacement";
    case ChannelKind::velocity:
      return "velocity";
    case ChannelKind::acceleration:
      break;
  }
  return "acceleration";
}

std::optional<ChannelKind> kind_of(const frf::Unit& unit, bool rotation) {
  if (unit.force == 1 && unit.time == 0 && unit.length == (rotation ? 1 : 0)) return ChannelKind::force;
  if (unit.force != 0 || unit.length != (rotation ? 0 : 1)) return std::nullopt;
  if (unit.time == 0) return ChannelKind::displacement;
  if (unit.time == -1) return ChannelKind::velocity;
  return unit.time == -2 ? std::optional(ChannelKind::acceleration) : std::nullopt;
}

frf::Quantity quantity_of(ChannelKind motion) {
  if (motion == ChannelKind::displacement) return frf::Quantity::receptance;
  return motion == ChannelKind::velocity ? frf::Quantity::mobility : frf::Quantity::accelerance;
}

std::vector<std::size_t> force_channels(const Record& record) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < record.channels.size(); ++i) {
    if (record.channels[i].kind == ChannelKind::force) found.push_back(i);
  }
  if (!found.empty()) return found;
  throw InputError({ErrorKind::data,
                    record.file,
                    {},
                    "has no channel that is a force",
                    "name its column or channel and its unit, e.g. --channel '2=1:+Z N' (in a scene: channels)"});
}

std::size_t force_channel(const Record& record) {
  const std::vector<std::size_t> found = force_channels(record);
  if (found.size() == 1) return found.front();
  throw InputError({ErrorKind::data,
                    record.file,
                    {},
                    "has two forces, " + record.channels[found[0]].name + " and " + record.channels[found[1]].name,
                    "name the channels of one force; several at once are for segments, with --shaker"});
}

std::vector<std::size_t> motion_channels(const Record& record) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < record.channels.size(); ++i) {
    if (record.channels[i].kind != ChannelKind::force) out.push_back(i);
  }
  if (out.empty())
    throw InputError({ErrorKind::data, record.file, {}, "has no response beside the force", "name one more channel"});
  return out;
}

bool has_delays(const Record& record) {
  return std::ranges::any_of(record.channels, [](const Channel& channel) { return channel.start_s != 0.0; });
}

Record from_common_start(const Record& record) {
  if (!has_delays(record)) return record;
  Record out = record;
  double last = 0.0;
  for (const Channel& channel : record.channels) last = std::max(last, channel.start_s);
  std::size_t shortest = record.samples();
  for (Channel& channel : out.channels) {
    const double early = std::round((last - channel.start_s) * record.rate_hz);
    if (!(early < static_cast<double>(channel.samples.size()))) {
      throw InputError({ErrorKind::data, record.file, "channel " + channel.name,
                        fmt::format("ends before the last channel begins, {:g} s after it", last - channel.start_s),
                        "export channels that were measured together"});
    }
    channel.samples.erase(channel.samples.begin(), channel.samples.begin() + static_cast<std::ptrdiff_t>(early));
    channel.start_s += early / record.rate_hz;
    shortest = std::min(shortest, channel.samples.size());
  }
  const double begin = out.channels.front().start_s;
  for (Channel& channel : out.channels) {
    channel.samples.resize(shortest);
    channel.start_s -= begin;
  }
  return out;
}

void require_alike(std::span<const Record> records) {
  for (const Record& record : records) require_like(records[0], record);
}

}  // namespace jointid::records

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "frf/set/dof.hpp"
#include "frf/set/quantity.hpp"
#include "frf/set/unit_label.hpp"

namespace jointid::records {

/// What a channel measured.
enum class ChannelKind : std::uint8_t { force, displacement, velocity, acceleration };

std::string name(ChannelKind kind);

/// By the dimension of a unit: N, m, m/s, m/s² (for rotations N·m, 1, 1/s, 1/s²); empty for any other.
std::optional<ChannelKind> kind_of(const frf::Unit& unit, bool rotation);

/// What an FRF of such a motion over a force is.
frf::Quantity quantity_of(ChannelKind motion);

/// One sensor over time.
struct Channel {
  std::string name;  ///< as the file calls it
  frf::Dof dof;      ///< where it stood, with the sign of its direction
  ChannelKind kind = ChannelKind::force;
  std::vector<double> samples{};  ///< SI units, as the sensor gave them: the sign of `dof` is not applied
  double start_s = 0.0;           ///< when its first sample was taken, after that of the record's first channel
};

/// Channels that were sampled together: one blow of a hammer, several, or a long record. All have the same number of samples.
struct Record {
  std::string file;
  double rate_hz = 0.0;  ///< samples per second
  std::vector<Channel> channels{};

  std::size_t samples() const { return channels.empty() ? 0 : channels.front().samples.size(); }
};

/// The places of the channels that are forces, in their order.
std::vector<std::size_t> force_channels(const Record& record);

/// The place of the one force channel. Throws InputError (data) where there is none or several.
std::size_t force_channel(const Record& record);

/// The places of all others. Throws InputError (data) where there are none.
std::vector<std::size_t> motion_channels(const Record& record);

/// Whether some channel begins before or after the others.
bool has_delays(const Record& record);

/// The same record from where all its channels have begun: whole samples are left out, what is less stays in `start_s`. Throws
/// InputError (data) where they have no time in common.
Record from_common_start(const Record& record);

/// Throws InputError (data) unless all records have the rate and the motions (DOFs, kinds, order) of the first, and its forces
/// where there are several.
void require_alike(std::span<const Record> records);

}  // namespace jointid::records

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frf/set/dof.hpp"

namespace jointid::records {

/// What the user says of a channel: its column, where it stood, and what its numbers are: SI = factor · (unit in SI) · number.
struct GivenChannel {
  std::string column;  ///< name, or number from 1; of UFF the number of the channel in its run
  frf::Dof dof;
  double factor = 1.0;
  std::string unit;  ///< empty: as the file states it
};

/// Parses "3=4:+Z g", "F=1:+Z N", "volts=1:+Z 44.5 N" (DOF, factor if any, unit), "F=1:+Z" (unit of the file). Throws InputError
/// (usage).
GivenChannel parse_channel(const std::string& text);

/// What the user knows of a file and the file does not say. What a file states and an option contradicts is an error.
struct RecordOptions {
  std::vector<GivenChannel> channels;  ///< those to read, in this order; needed by all files but UFF with directions and units
  std::string time;  ///< column of the times; default: the first that is_time_column(), or named x; none with a rate. Not of UFF
  std::optional<double> rate_hz{};  ///< of files that state none, or times that are not even
  bool any_dof = false;             ///< what UFF states of DOFs does not matter: one signal is wanted, `channels` names it
  std::string unit_otherwise{};     ///< of channels without a unit where the file states none
};

}  // namespace jointid::records

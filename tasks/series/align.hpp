#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ident/result/control.hpp"
#include "records/file/read_series.hpp"

namespace jointid::tasks {

/// How late the channels of a periodic record are, as it is asked for.
struct AlignTask {
  std::filesystem::path file;
  std::string reference;      ///< name or number of the channel that is right
  double frequency_hz = 0.0;  ///< of the motion
  std::size_t harmonics = 3;  ///< fitted together
  std::optional<double> rate_hz;
};

/// A channel of the record.
struct LateChannel {
  std::string name;
  double amplitude = 0.0;  ///< of the fundamental, in the channel's unit
  double delay = 0.0;      ///< s, in (−1/2f, 1/2f]
  double rest = 0.0;       ///< rms of what no harmonic holds, over the rms without the mean
};

/// What run_align() finds.
struct AlignResult {
  AlignTask task;
  records::SeriesRecord record;       ///< as it was measured
  std::vector<LateChannel> channels;  ///< of the record, in its order
};

/// Reads the record, fits the harmonics of every channel and compares their phases with the reference's. Stages "reading samples"
/// and "harmonics", channels done of all. Throws InputError, and Interrupted between channels.
AlignResult run_align(const AlignTask& task, const ident::Control& control = {});

/// The same of a record in memory; the task's file and rate are not used.
AlignResult run_align(const AlignTask& task, records::SeriesRecord record, const ident::Control& control = {});

/// The samples of a channel without its delay, as many as were measured; NaN where they would be beyond the record.
std::vector<double> aligned(const AlignResult& found, std::size_t channel);

}  // namespace jointid::tasks

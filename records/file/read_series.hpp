#pragma once

#include <filesystem>

#include "records/file/sample_stream.hpp"

namespace jointid::records {

/// What the user knows of a record and the file does not say.
struct SeriesOptions {
  std::vector<std::string> channels;  ///< names or numbers; empty: all but the time
  std::optional<double> rate_hz;      ///< of files that state none, or times that are not even
  std::size_t most_samples = 0;       ///< the first so many; 0: all
  bool without_times = false;         ///< the rate does not matter and stays 0
};

/// Channels in memory, a column each; NaN where a sample is missing.
struct SeriesRecord {
  std::string file;
  double rate_hz = 0.0;
  std::vector<StreamChannel> channels;
  std::vector<std::vector<double>> samples;
  bool is_cut = false;  ///< the file has more than most_samples
};

/// Rate: of the file (UFF), or of the column of times, which must be even and in a unit that is understood; else of the options,
/// which must not contradict it (stated_or_given_rate()). Throws InputError.
SeriesRecord read_series(const std::filesystem::path& path, const SeriesOptions& options);

}  // namespace jointid::records

#pragma once

#include <filesystem>

#include "records/file/sample_stream.hpp"

namespace jointid::records {

/// What the user knows of a record and the file does not say.
struct SeriesOptions {
  std::vector<std::string> channels;  ///< names or numbers; empty: all but the time
  std::optional<double> rate_hz;      ///< counts before the file
  std::size_t most_samples = 0;       ///< the first so many; 0: all
};

/// Channels in memory, a column each; NaN where a sample is missing.
struct SeriesRecord {
  std::string file;
  double rate_hz = 0.0;
  std::vector<StreamChannel> channels;
  std::vector<std::vector<double>> samples;
  bool is_cut = false;  ///< the file has more than most_samples
};

/// Rate: of the options, of the file (UFF), or of the column of times, which must be even (rate_of()). Throws InputError.
SeriesRecord read_series(const std::filesystem::path& path, const SeriesOptions& options);

}  // namespace jointid::records

#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "records/file/read_series.hpp"
#include "report/page/contents.hpp"
#include "report/text/table.hpp"

namespace jointid::report {

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
  double amplitude = 0.0;  ///< of the fundamental
  double delay = 0.0;      ///< s, in (−1/2f, 1/2f]
  double rest = 0.0;       ///< rms of what no harmonic holds, over the rms without the mean
};

struct AlignReport {
  AlignTask task;
  records::SeriesRecord record;  ///< as it was measured
  std::vector<LateChannel> channels;
};

/// Throws InputError.
AlignReport align_report(const AlignTask& task);

/// Channels in which the motion of this frequency is not what is seen most: their delays mean little.
std::vector<std::string> align_remarks(const AlignReport& report);
Table delays_table(const AlignReport& report);
/// Three periods of every channel over its amplitude, as measured and aligned.
PlotGroup align_plots(const AlignReport& report);
/// "'beam' is 0.0031 s late against slider."
std::string align_summary(const AlignReport& report);

/// For people.
std::string align_text(const AlignReport& report);
/// The keys stay.
std::string align_json(const AlignReport& report);
/// The record without the delays: "time [s],NAME [unit],…" and a row a sample; missing samples are empty cells.
std::string align_csv(const AlignReport& report);
/// The page of `jointid series align`.
std::string align_page(const AlignReport& report);

}  // namespace jointid::report

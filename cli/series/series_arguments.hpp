#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/options/target.hpp"
#include "report/series/contact_report.hpp"
#include "report/series/delay_task.hpp"

namespace jointid::cli {

/// `series delay`: delay, dimension and exponents of one channel.
struct SeriesDelayArguments : report::DelayTask {
  Target json, csv, report;
};

/// `series strain`: displacements of a clamped beam from strain gauges.
struct SeriesStrainArguments {
  std::filesystem::path file;
  std::vector<std::string> channels;
  double length = 0.0, thickness = 0.0;
  std::vector<double> gauges, points;
  std::size_t shapes = 0;  ///< 0: as many as gauges
  bool static_shapes = false;
  Target output, json;
};

/// `series friction`: the law of a contact from a record of it.
struct SeriesFrictionArguments : report::ContactTask {
  Target json, csv, report;
};

/// `series align`: how late the channels of a periodic record are.
struct SeriesAlignArguments {
  std::filesystem::path file;
  std::string reference;
  double frequency_hz = 0.0;
  std::size_t harmonics = 3;
  std::optional<double> rate_hz;
  Target output, json;
};

}  // namespace jointid::cli

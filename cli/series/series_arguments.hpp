#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/options/target.hpp"

namespace jointid::cli {

/// `series delay`: delay, dimension and exponents of one channel.
struct SeriesDelayArguments {
  std::filesystem::path file;
  std::string channel;  ///< name or number; empty: the only one
  std::optional<double> rate_hz;
  std::size_t samples = 20'000;  ///< the first so many
  std::size_t cells = 16, most_lag = 100;
  std::size_t delay = 0;      ///< samples; 0: the first minimum of the information
  std::size_t dimension = 0;  ///< 0: by false neighbours
  std::size_t most_dimension = 8;
  std::size_t theiler = 0;  ///< samples; 0: twice the delay times the dimension
  std::size_t steps = 150;  ///< of divergence curves
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
struct SeriesFrictionArguments {
  std::filesystem::path file;
  std::string velocity, force, normal;  ///< columns
  double load = 0.0;                    ///< N where there is no column of it
  double stick_speed = 0.0;
  std::optional<double> rate_hz;
  double force_delay = 0.0;  ///< s by which the force is late
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

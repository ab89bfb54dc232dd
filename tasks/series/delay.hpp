#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ident/result/control.hpp"
#include "oscillation/delay/correlation.hpp"
#include "oscillation/delay/divergence.hpp"
#include "oscillation/delay/false_neighbours.hpp"
#include "oscillation/delay/mutual_information.hpp"
#include "oscillation/delay/recurrence.hpp"
#include "oscillation/delay/wolf.hpp"
#include "records/file/read_series.hpp"

namespace jointid::tasks {

/// What is asked of one channel: delay, dimension and exponents.
struct DelayTask {
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
  std::vector<std::size_t> wolf;                   ///< samples over which Wolf's exponent follows a pair; empty: it is not asked for
  std::optional<std::array<double, 2>> wolf_range;  ///< distances of new pairs, in the unit of the channel; 0.001 and 0.1 deviations
};

/// Wolf's exponent by one time of evolution.
struct WolfRow {
  std::size_t evolve = 0;  ///< samples
  oscillation::WolfExponent found;
};

/// What the tools of series/delay/ say of one channel.
struct DelayResult {
  std::string file, channel, unit;
  double rate_hz = 0.0;
  std::size_t samples = 0;                          ///< used
  oscillation::InformationCurve information;             ///< bits over the lag
  double information_bias = 0.0;                    ///< bits
  std::vector<oscillation::FalseNeighbours> neighbours;  ///< a row a dimension
  oscillation::Embedding embedding;                      ///< used below
  bool delay_given = false, dimension_given = false;
  std::size_t theiler = 0;  ///< samples
  oscillation::CorrelationDimension correlation;
  oscillation::RecordExponent rosenstein, kantz;  ///< nats a second
  std::vector<WolfRow> wolf;                 ///< bits a second, a row a time of evolution
  std::array<double, 2> wolf_range{};        ///< used
  double recurrence_radius = 0.0;            ///< in the unit of the channel
  std::vector<oscillation::RecurrentPeriod> recurrences;
  std::vector<std::string> remarks;
};

/// Reads the channel and asks one tool after another, whose names are the stages of the progress. Throws InputError, and
/// Interrupted between tools.
DelayResult run_delay(const DelayTask& task, const ident::Control& control = {});

/// The same of the first channel of a record in memory; the task's file, channel and rate are not used.
DelayResult run_delay(const DelayTask& task, const records::SeriesRecord& record, const ident::Control& control = {});

}  // namespace jointid::tasks

#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace jointid::report {

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
};

}  // namespace jointid::report

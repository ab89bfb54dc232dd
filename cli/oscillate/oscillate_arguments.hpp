#pragma once

#include <cstddef>
#include <filesystem>

#include "cli/options/target.hpp"

namespace jointid::cli {

struct OscillateArguments {
  std::filesystem::path scene;
  std::size_t threads = 0;  ///< 0: all cores
  Target json, csv, report;
  Target sweep, events;  ///< tables of their own
};

}  // namespace jointid::cli

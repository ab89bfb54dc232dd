#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/options/target.hpp"

namespace jointid::cli {

struct PodArguments {
  std::vector<std::filesystem::path> files;
  std::vector<std::string> channels;     ///< names or numbers of columns; empty: all but that of time
  std::string mass, stiffness, compare;  ///< files; empty: none
  bool keep_mean = false;
  std::size_t threads = 1;  ///< 0: all cores
  Target json, csv, report;
};

}  // namespace jointid::cli

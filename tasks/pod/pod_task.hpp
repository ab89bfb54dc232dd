#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "ident/scene/scene_files.hpp"

namespace jointid::tasks {

/// Proper orthogonal modes as they are asked for.
struct PodTask {
  std::vector<std::filesystem::path> files;  ///< several are further samples of the same channels
  std::vector<std::string> channels;         ///< names or numbers of columns; empty: all but that of time
  std::string mass, stiffness, compare;      ///< files of n × n matrices and of modes, n × m; empty: none
  bool keep_mean = false;
  std::size_t threads = 1;  ///< 0: all cores. The result does not depend on it.
};

/// All files that are read, and the options that name them.
std::vector<ident::NamedFile> files_of(const PodTask& task);

/// Throws InputError for what cannot be had together.
void check(const PodTask& task);

}  // namespace jointid::tasks

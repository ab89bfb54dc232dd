#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace jointid::cli {

/// A folder of its own for temporary files that vanishes with the object. `path()` is empty where none can be made.
class WorkFolder {
 public:
  WorkFolder();
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// How a program ended; `exit_code` −1: it could not be started, or a signal ended it.
struct Ended {
  int exit_code = -1;
};

/// Runs a program, words[0] its path, to its end: no input, its output nowhere. `folder`: where it works; empty: here. `errors`: what it
/// says on standard error is seen.
Ended run_program(std::vector<std::string> words, const std::filesystem::path& folder = {}, bool errors = false);

/// Whether it ended with 0.
bool ended_well(std::vector<std::string> words);

}  // namespace jointid::cli

#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace jointid::cli {

/// --resume, --stop-before and --state of commands that keep what they found so far.
struct ResumeOptions {
  bool resume = false;
  std::optional<double> stop_before{};  ///< seconds of wall time
  std::filesystem::path state{};        ///< empty: by the scene's name

  /// Whether one of the three was given: the state is kept from the start, and not first when the command is interrupted.
  bool keeps_from_start() const { return resume || stop_before || !state.empty(); }
};

/// `what`: what is kept, "the finished force levels"; `end`: of the default name of the file, ".response.partial".
void add_resume(CLI::App* command, ResumeOptions& options, const std::string& what, const std::string& end);

/// Throws InputError (usage) for seconds that are not above 0.
void check(const ResumeOptions& options);

/// --state, or the scene's name with `end`, here.
std::filesystem::path state_file(const ResumeOptions& options, const std::filesystem::path& scene, const std::string& end);

/// Whether an end was asked for, or the seconds from now on are over.
std::function<bool()> is_over(const ResumeOptions& options);

}  // namespace jointid::cli

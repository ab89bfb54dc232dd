#include "cli/resume/resume_options.hpp"

#include <CLI/CLI.hpp>

#include "base/error.hpp"
#include "base/stopwatch.hpp"
#include "cli/text/interrupt.hpp"

namespace jointid::cli {

void add_resume(CLI::App* command, ResumeOptions& options, const std::string& what, const std::string& end) {
  command->add_flag("--resume", options.resume, "Continue an interrupted run; start one where none was");
  command->add_option("--stop-before", options.stop_before, "Stop after so many seconds; --resume continues");
  command->add_option("--state", options.state,
                      "Where " + what + " are kept until the run is complete; default: SCENE's name with " + end + ", here");
}

void check(const ResumeOptions& options) {
  if (options.stop_before && !(*options.stop_before > 0.0))
    throw InputError({ErrorKind::usage, "", "--stop-before", "it is not above 0", "give seconds"});
}

std::filesystem::path state_file(const ResumeOptions& options, const std::filesystem::path& scene, const std::string& end) {
  return options.state.empty() ? std::filesystem::path(scene.stem().string() + end) : options.state;
}

std::function<bool()> is_over(const ResumeOptions& options) {
  return [stop_before = options.stop_before, begun = Clock::now()] {
    return interrupted() || (stop_before && seconds_since(begun) > *stop_before);
  };
}

}  // namespace jointid::cli

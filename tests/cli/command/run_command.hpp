#pragma once

#include <sys/types.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

namespace jointid::cli {

/// What a run of the command left: exit code (128 + signal when one ended it) and what it printed.
struct Outcome {
  int code = -1;
  std::string out, err;
};

/// The real `jointid` as a process of its own in `folder`; stdout and stderr go to files without a name, or where the
/// caller says.
class Command {
 public:
  struct Streams {
    int out = -1, err = -1;  ///< descriptors; -1: keep what is printed for `wait`
  };

  Command(const std::filesystem::path& folder, const std::vector<std::string>& arguments, Streams streams);
  Command(const std::filesystem::path& folder, const std::vector<std::string>& arguments)
      : Command(folder, arguments, Streams()) {}
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;
  ~Command();

  void interrupt(int signal = SIGINT) const;
  /// Waits until the command catches Ctrl-C.
  void wait_until_it_catches();
  bool has_ended();
  Outcome wait();

 private:
  int out_, err_;
  pid_t process_ = -1;
  int status_ = 0;
  bool ended_ = false;
};

/// Starts the command and waits for its end.
Outcome run_command(const std::filesystem::path& folder, const std::vector<std::string>& arguments);

}  // namespace jointid::cli

#include "run_command.hpp"

#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <stdexcept>

namespace jointid::cli {
namespace {

int nameless_file() { return ::memfd_create("printed", MFD_CLOEXEC); }

std::string content(int descriptor) {
  std::string text;
  std::array<char, 4096> piece{};
  ::lseek(descriptor, 0, SEEK_SET);
  for (ssize_t got = 0; (got = ::read(descriptor, piece.data(), piece.size())) > 0;) {
    text.append(piece.data(), static_cast<std::size_t>(got));
  }
  return text;
}

}  // namespace

Command::Command(const std::filesystem::path& folder, const std::vector<std::string>& arguments, Streams streams)
    : out_(nameless_file()), err_(nameless_file()) {
  std::vector<std::string> words = arguments;
  words.insert(words.begin(), JOINTID_COMMAND);
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_adddup2(&actions, streams.out < 0 ? out_ : streams.out, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, streams.err < 0 ? err_ : streams.err, STDERR_FILENO);
  const int failed = ::posix_spawn(&process_, JOINTID_COMMAND, &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) throw std::runtime_error("cannot start " JOINTID_COMMAND);
}

Command::~Command() {
  if (!ended_) {
    ::kill(process_, SIGKILL);
    wait();
  }
  ::close(out_);
  ::close(err_);
}

void Command::interrupt(int signal) const { ::kill(process_, signal); }

void Command::wait_until_it_catches() {
  const auto catches = [this] {
    std::ifstream status("/proc/" + std::to_string(process_) + "/status");
    for (std::string line; std::getline(status, line);) {
      if (line.starts_with("SigCgt:")) return (std::stoull(line.substr(7), nullptr, 16) >> (SIGINT - 1) & 1U) != 0;
    }
    return false;
  };
  while (!catches() && !has_ended()) ::usleep(1000);
}

bool Command::has_ended() {
  if (!ended_) ended_ = ::waitpid(process_, &status_, WNOHANG) == process_;
  return ended_;
}

Outcome Command::wait() {
  if (!ended_) ended_ = ::waitpid(process_, &status_, 0) == process_;
  const int code = WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
  return {code, content(out_), content(err_)};
}

Outcome run_command(const std::filesystem::path& folder, const std::vector<std::string>& arguments) {
  return Command(folder, arguments).wait();
}

}  // namespace jointid::cli

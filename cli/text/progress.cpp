#include "cli/text/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "cli/text/interrupt.hpp"

namespace jointid::cli {
namespace {

constexpr const char* clear_line = "\r\x1b[K";

}  // namespace

Progress::Progress() : terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (shown_) std::fputs(clear_line, stderr);
}

void Progress::print(const std::string& text) {
  std::fputs((clear_line + text).c_str(), stderr);
  std::fflush(stderr);
  shown_ = true;
}

void Progress::show(const std::string& text) {
  if (!terminal_ || interrupted()) return;
  const std::lock_guard lock(mutex_);
  stage_.clear();
  print(text);
}

void Progress::count(const std::string& stage, std::size_t done, std::size_t total) {
  if (!terminal_ || interrupted()) return;
  const std::lock_guard lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  if (stage == stage_ && now - counted_ < std::chrono::milliseconds(100)) return;
  stage_ = stage;
  counted_ = now;
  print(total == 0 ? stage : fmt::format("{}: {} {} of {}", stage, stage == "bootstrap" ? "replicate" : "line", done, total));
}

ident::Control Progress::control() {
  return {.progress = [this](const char* stage, std::size_t done, std::size_t total) { count(stage, done, total); },
          .interrupted = interrupted};
}

}  // namespace jointid::cli

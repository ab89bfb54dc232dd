#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "cli/interrupt.hpp"

namespace jointid::cli {
namespace {

constexpr const char* clear_line = "\r\x1b[K";

}  // namespace

Progress::Progress() : terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (shown_) std::fputs(clear_line, stderr);
}

void Progress::show(const std::string& text) {
  if (!terminal_) return;
  std::fputs((clear_line + text).c_str(), stderr);
  std::fflush(stderr);
  shown_ = true;
}

ident::Control Progress::control() {
  return {.progress = [this](const char* stage, std::size_t done, std::size_t total) { show(fmt::format("{}: line {} of {}", stage, done, total)); },
          .interrupted = interrupted};
}

}  // namespace jointid::cli

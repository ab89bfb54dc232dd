#pragma once

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace jointid::cli {

/// A pseudo-terminal, on which the command shows its progress.
class Terminal {
 public:
  Terminal() : master_(::posix_openpt(O_RDWR | O_NOCTTY)) {
    if (master_ < 0 || ::grantpt(master_) != 0 || ::unlockpt(master_) != 0) throw std::runtime_error("no terminal");
    slave_ = ::open(::ptsname(master_), O_RDWR | O_NOCTTY);
    if (slave_ < 0) throw std::runtime_error("no terminal");
  }
  ~Terminal() {
    ::close(slave_);
    ::close(master_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  int descriptor() const { return slave_; }

  /// What was shown next; waits for it, but no longer than a minute.
  std::string next() const {
    pollfd shown{.fd = master_, .events = POLLIN, .revents = 0};
    if (::poll(&shown, 1, 60000) != 1) throw std::runtime_error("the command shows nothing");
    std::array<char, 4096> piece{};
    const ssize_t got = ::read(master_, piece.data(), piece.size());
    return {piece.data(), got < 0 ? 0U : static_cast<std::size_t>(got)};
  }

  /// All that is shown until a text appears.
  std::string until(const std::string& text) const {
    std::string shown;
    while (shown.find(text) == std::string::npos) shown += next();
    return shown;
  }

 private:
  int master_, slave_ = -1;
};

}  // namespace jointid::cli

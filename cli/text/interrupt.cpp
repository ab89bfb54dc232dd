#include "cli/text/interrupt.hpp"

#include <semaphore.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <ctime>
#include <iostream>
#include <string_view>
#include <system_error>
#include <thread>

#include "base/temporary_file.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/text/failure.hpp"
#include "ident/team/team.hpp"

namespace jointid::cli {
namespace {

using std::chrono_literals::operator""ms;

constexpr std::string_view heard = "jointid: stopping and keeping the partial result; Ctrl-C again stops at once\n";
constexpr std::string_view clear_terminal_line = "\r\x1b[K";

/// What a signal handler may touch.
std::atomic<bool> asked_to_end = false, speaks = true, on_terminal = false;
static_assert(std::atomic<bool>::is_always_lock_free);
sem_t wake_watch;

std::atomic<bool> ending = false;
std::timed_mutex speaker_mutex;
LastWords* last_speaker = nullptr;

void say(std::string_view text) { (void)!::write(STDERR_FILENO, text.data(), text.size()); }

extern "C" void on_signal(int) {
  const int error = errno;
  if (asked_to_end.exchange(true)) {
    remove_unfinished();
    _exit(static_cast<int>(ExitCode::interrupted));
  }
  sem_post(&wake_watch);  // first: a full pipe holds up what is said
  if (speaks) {
    if (on_terminal) say(clear_terminal_line);
    say(heard);
  }
  errno = error;
}

}  // namespace

/// Ends the process when its work does not.
class InterruptWatch {
 public:
  static void start() {
    sem_init(&wake_watch, 0, 0);
    try {
      std::thread(watch).detach();
    } catch (const std::system_error&) {
      // No memory for a thread: the work itself asks whether it is to end.
    }
  }

 private:
  static void watch() {
    while (sem_wait(&wake_watch) != 0) {
    }
    std::this_thread::sleep_for(ident::process_number() == 0 ? 1500ms : 1800ms);  // mpirun ends all when one has ended
    end_process();
  }

  /// What the command has to say, unless it is about to save that itself.
  static std::string last_words() {
    const std::unique_lock lock(speaker_mutex, 250ms);
    if (!lock || last_speaker == nullptr) return "interrupted";
    try {
      if (!last_speaker->spoken_) last_speaker->spoken_ = last_speaker->save_();
      return *last_speaker->spoken_;
    } catch (...) {
      return "interrupted; " + explain(std::current_exception()).line;
    }
  }

  /// Does what writes to a stream, and leaves it where nobody reads that: a full pipe would hold it up for ever.
  template <class Act>
  static void act_or_leave(sem_t& done, Act act) {
    sem_init(&done, 0, 0);
    try {
      std::thread([&done, act] {
        act();
        sem_post(&done);
      }).detach();
    } catch (const std::system_error&) {
      return;  // no memory for a thread
    }
    timespec until{};
    clock_gettime(CLOCK_REALTIME, &until);
    constexpr long patience = 200'000'000, second = 1'000'000'000;  // ns
    until.tv_sec += (until.tv_nsec + patience) / second;
    until.tv_nsec = (until.tv_nsec + patience) % second;
    while (sem_timedwait(&done, &until) != 0 && errno == EINTR) {
    }
  }

  static void flush_and_say(const std::string& line) {
    static sem_t flushed, said;
    act_or_leave(flushed, [] { std::cout.flush(); });
    act_or_leave(said, [line] {
      if (speaks && on_terminal) say(clear_terminal_line);
      if (speaks) say("jointid: error: " + line + "\n");
    });
  }

  [[noreturn]] static void end_process() {
    if (!ending.exchange(true)) {
      flush_and_say(last_words());
    } else {
      std::this_thread::sleep_for(250ms);  // the end is being told already
    }
    remove_unfinished();
    _exit(static_cast<int>(ExitCode::interrupted));
  }
};

void catch_interrupts() {
  static std::once_flag started;
  std::call_once(started, [] {
    speaks = ident::process_number() == 0;
    on_terminal = isatty(STDERR_FILENO) == 1;
    InterruptWatch::start();
    struct sigaction action {};
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
  });
}

bool interrupted() noexcept { return asked_to_end.load(); }

void claim_end() {
  while (ending.exchange(true)) pause();
}

LastWords::LastWords(std::function<std::string()> save) : save_(std::move(save)) {
  const std::lock_guard lock(speaker_mutex);
  last_speaker = this;
}

LastWords::~LastWords() {
  const std::lock_guard lock(speaker_mutex);
  last_speaker = nullptr;
}

std::string LastWords::speak() {
  const std::lock_guard lock(speaker_mutex);
  if (!spoken_) spoken_ = save_();
  return *spoken_;
}

}  // namespace jointid::cli

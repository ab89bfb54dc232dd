#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "ident/result/control.hpp"

namespace jointid::cli {

/// From now on SIGINT and SIGTERM ask for an end, and say at once on stderr that they were heard. Work that polls `interrupted()`
/// then stops between lines and keeps partial results. What has not ended 1.5 s later is ended from another thread: the LastWords
/// of the command are spoken, files that are half written are removed, and the exit code is 130. A second signal does the same at
/// once, without words.
void catch_interrupts();

/// Whether an end was asked for.
bool interrupted() noexcept;

/// Called before the end of an interrupted process is told and its exit code given: returns once, to whoever ends the process; to all
/// others never.
void claim_end();

/// What is saved of the work of a command that is interrupted.
class LastWords {
 public:
  /// `save` writes what there is and returns what is to be told in the error line. It is called at most once, by the thread that works
  /// or, when that does not stop in time, by another. One LastWords lives at a time.
  explicit LastWords(std::function<std::string()> save);
  ~LastWords();
  LastWords(const LastWords&) = delete;
  LastWords& operator=(const LastWords&) = delete;

  /// Saves, unless that was done; what is to be told.
  std::string speak();

 private:
  friend class InterruptWatch;
  std::function<std::string()> save_;
  std::optional<std::string> spoken_;
};

/// Does `work`; when that is interrupted, `save` is what is saved, and Interrupted tells its words.
template <class Work>
auto with_last_words(std::function<std::string()> save, Work&& work) {
  LastWords words(std::move(save));
  try {
    return std::forward<Work>(work)();
  } catch (const Interrupted&) {
    throw Interrupted(words.speak());
  }
}

/// The best result so far of work that goes on.
template <class T>
class SoFar {
 public:
  void put(T result) {
    const std::lock_guard lock(mutex_);
    result_ = std::move(result);
  }
  std::optional<T> get() const {
    const std::lock_guard lock(mutex_);
    return result_;
  }

 private:
  mutable std::mutex mutex_;
  std::optional<T> result_;
};

}  // namespace jointid::cli

#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <utility>

#include "ident/result/control.hpp"

namespace jointid::cli {

/// One line on stderr that says how far a run is; nothing when stderr is no terminal. The line is gone afterwards. May be used by
/// several threads at once.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(const std::string& text);

  /// "STAGE: line 12 of 400", at most ten times per second while the stage stays; of 0 the stage alone.
  void count(const std::string& stage, std::size_t done, std::size_t total);

  /// Progress and Ctrl-C for the library.
  ident::Control control();

 private:
  void print(const std::string& text);

  bool terminal_;
  bool shown_ = false;
  std::mutex mutex_;
  std::string stage_;
  std::chrono::steady_clock::time_point counted_;
};

/// Does `work` and says meanwhile what it is.
template <class Work>
auto with_progress(const char* what, Work&& work) {
  Progress progress;
  progress.show(what);
  return std::forward<Work>(work)();
}

}  // namespace jointid::cli

#pragma once

#include <string>

#include "ident/solve.hpp"

namespace jointid::cli {

/// One line on stderr that says how far a run is; nothing when stderr is no terminal. The line is gone afterwards.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(const std::string& text);

  /// Progress and Ctrl-C for the library.
  ident::Control control();

 private:
  bool terminal_;
  bool shown_ = false;
};

}  // namespace jointid::cli

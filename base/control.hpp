#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace jointid {

/// Thrown where a caller asked to end.
class Interrupted : public std::runtime_error {
 public:
  explicit Interrupted(const std::string& what = "interrupted") : std::runtime_error(what) {}
};

/// Throws Interrupted when the caller asks to end; an empty function never does.
inline void stop_if(const std::function<bool()>& interrupted) {
  if (interrupted && interrupted()) throw Interrupted();
}

}  // namespace jointid

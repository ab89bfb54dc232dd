#pragma once

#include <type_traits>

#include "base/error.hpp"

namespace jointid::scene {

/// Whether `read` reads, and says yes where it answers; what it refuses counts as not written.
template <class Read>
bool if_readable(Read read) {
  try {
    if constexpr (std::is_void_v<decltype(read())>) {
      read();
      return true;
    } else {
      return read();
    }
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace jointid::scene

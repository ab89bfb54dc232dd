#pragma once

#include <cstddef>
#include <functional>

namespace jointid {

/// Most bytes that operator new had given out at a time during `work`, beyond those before. Linking this replaces operator new.
/// What C libraries allocate for themselves is not counted.
std::size_t peak_bytes_of(const std::function<void()>& work);

}  // namespace jointid

#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string_view>

namespace jointid {

/// JOINTID_REQUIRE_ALL=1 says that this machine has all that tests use: one that is skipped there hides that something is gone.
inline bool all_is_required() {
  const char* value = std::getenv("JOINTID_REQUIRE_ALL");
  return value != nullptr && std::string_view(value) == "1";
}

}  // namespace jointid

/// Ends a test, or its SetUp, that lacks data, a library or a right: skipped, or failed where all is required. `reason` names
/// what is missing and may be streamed, JOINTID_SKIP(path << " is missing"). A macro because no function can end its caller.
#define JOINTID_SKIP(reason)                          \
  do {                                                \
    if (jointid::all_is_required()) FAIL() << reason; \
    GTEST_SKIP() << reason;                           \
  } while (false)

#pragma once

#include <filesystem>
#include <optional>

namespace jointid::cli {

/// jointid-all beside this program, if it was built: it has every command. `jointid` has those that lead from FRFs to a joint,
/// which are built in half the time, and leaves the rest to it.
std::optional<std::filesystem::path> complete_program();

/// What to do where it is missing.
inline constexpr const char* how_to_complete = "build all of jointid: scripts/build release";

/// Goes on as jointid-all with the same arguments. Returns only where there is none. Throws InputError when it cannot be started.
void go_on_complete(const char* const* argv);

}  // namespace jointid::cli

#include "cli/options/complete_program.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/error.hpp"

namespace jointid::cli {

std::optional<std::filesystem::path> complete_program() {
  std::error_code unknown;
  const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe", unknown);
  const std::filesystem::path complete = own.parent_path() / "jointid-all";
  if (unknown || !std::filesystem::is_regular_file(complete, unknown)) return std::nullopt;
  return complete;
}

void go_on_complete(const char* const* argv) {
  const auto program = complete_program();
  if (!program) return;
  execv(program->c_str(), const_cast<char* const*>(argv));
  throw InputError({.kind = ErrorKind::usage,
                    .file = program->string(),
                    .place = {},
                    .problem = std::string("cannot be started: ") + std::strerror(errno),
                    .remedy = how_to_complete});
}

}  // namespace jointid::cli

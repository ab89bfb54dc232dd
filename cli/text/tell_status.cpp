#include "cli/text/tell_status.hpp"

#include "cli/text/failure.hpp"

namespace jointid::cli {

ExitCode tell_status(const std::string& of, Status status, const std::string& message) {
  if (!is_usable(status)) {
    print_error(of + ": " + message);
    return ExitCode::unusable;
  }
  if (status != Status::ok) print_warning(of + ": doubtful: " + message);
  return ExitCode::done;
}

}  // namespace jointid::cli

#include "cli/laws/law_status.hpp"

#include "cli/text/failure.hpp"

namespace jointid::cli {

ExitCode tell_status(const laws::LawScene& scene, laws::LawStatus status, const std::string& message) {
  if (status == laws::LawStatus::ok) return ExitCode::done;
  const std::string what = scene.file.string() + ": ";
  if (laws::is_usable(status)) {
    print_warning(what + "doubtful: " + message);
    return ExitCode::done;
  }
  print_error(what + message);
  return ExitCode::unusable;
}

}  // namespace jointid::cli

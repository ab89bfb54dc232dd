#pragma once

namespace jointid::cli {

/// From now on SIGINT and SIGTERM ask for an orderly end: work that polls `interrupted()` stops between lines and keeps
/// partial results. A second signal removes files that are half written and ends the process at once with exit code 130.
void catch_interrupts();

/// Whether an end was asked for.
bool interrupted() noexcept;

}  // namespace jointid::cli

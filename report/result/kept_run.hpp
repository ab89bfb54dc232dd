#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ident/result/solution.hpp"
#include "tasks/convergence.hpp"
#include "tasks/worth.hpp"

namespace jointid::report {

/// A file that a run read, as it was then.
struct RunInput {
  std::string file;  ///< as the scene names it, made absolute
  std::uint64_t bytes = 0;
  std::int64_t modified = 0;  ///< as the file system counts

  bool operator==(const RunInput&) const = default;
};

/// A solution with all that is needed to look at it later: its scene, and what was found beside it.
struct KeptRun {
  std::string made;   ///< "2026-11-30T17:31:02", local time
  std::string scene;  ///< the text
  std::vector<RunInput> inputs;
  ident::Solution solution;
  std::vector<tasks::WorthAnswer> worth;
  tasks::UnknownsByIteration iterations;
};

/// As JSON: format "jointid-run", version 1, the solution under "solution" with the keys of solution_json().
std::string kept_run_json(const KeptRun& run);

/// The same back. Throws InputError (data) for anything else.
KeptRun read_kept_run(const std::string& text);

}  // namespace jointid::report

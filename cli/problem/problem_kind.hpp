#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "problems/kinds/problem_kind.hpp"

namespace jointid::cli {

/// The built-in problems of a program, in the order of `problem list`.
struct ProblemKinds {
  std::span<const problems::ProblemKind> kinds;
  bool all = false;  ///< false: jointid-all has more

  bool have(const std::string& name) const;

  /// Throws InputError (usage) with the nearest name when there is none.
  problems::WrittenProblem write(const std::string& name, const std::filesystem::path& directory,
                                 const problems::WriteOptions& options) const;
};

/// Those that lead from FRFs to a joint, to an assembly or to modes.
ProblemKinds linear_problems();

}  // namespace jointid::cli

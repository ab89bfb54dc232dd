#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "problems/case/problem_info.hpp"
#include "problems/case/write_options.hpp"

namespace jointid::cli {

/// A built-in problem that was written, and the command that goes on from it.
struct WrittenProblem {
  std::filesystem::path file;
  std::string next;
};

/// Built-in problems that are made alike.
struct ProblemKind {
  std::vector<problems::ProblemInfo> (*list)();
  /// One of the list, into a folder.
  WrittenProblem (*write)(const std::string& name, const std::filesystem::path& directory, const problems::WriteOptions& options);
};

/// The built-in problems of a program, in the order of `problem list`.
struct ProblemKinds {
  std::span<const ProblemKind> kinds;
  bool all = false;  ///< false: jointid-all has more

  bool have(const std::string& name) const;

  /// Throws InputError (usage) with the nearest name when there is none.
  WrittenProblem write(const std::string& name, const std::filesystem::path& directory,
                       const problems::WriteOptions& options) const;
};

/// Those that lead from FRFs to a joint, to an assembly or to modes.
ProblemKinds linear_problems();

WrittenProblem write_identification_problem(const std::string& name, const std::filesystem::path& directory,
                                            const problems::WriteOptions& options);
WrittenProblem write_coupling_problem(const std::string& name, const std::filesystem::path& directory,
                                      const problems::WriteOptions& options);
WrittenProblem write_modal_set(const std::string& name, const std::filesystem::path& directory,
                               const problems::WriteOptions& options);

}  // namespace jointid::cli

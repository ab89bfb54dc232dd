#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "problems/case/problem_info.hpp"
#include "problems/case/write_options.hpp"

namespace jointid::problems {

/// A built-in problem that was written, and the command that goes on from it.
struct WrittenProblem {
  std::filesystem::path file;
  std::string next;
};

/// Built-in problems that are made alike.
struct ProblemKind {
  std::vector<ProblemInfo> (*list)();
  /// One of the list, into a folder.
  WrittenProblem (*write)(const std::string& name, const std::filesystem::path& directory, const WriteOptions& options);
};

/// All kinds, in the order of `problem list`.
std::span<const ProblemKind> all_kinds();

/// Those that lead from FRFs to a joint, to an assembly or to modes, in the same order.
std::span<const ProblemKind> linear_kinds();

/// The kind that has a problem of that name, or null.
const ProblemKind* kind_of(std::span<const ProblemKind> kinds, const std::string& name);

/// The names of all problems of some kinds.
std::vector<std::string> names_of(std::span<const ProblemKind> kinds);

/// How those of linear_kinds() are written.
WrittenProblem write_identification_problem(const std::string& name, const std::filesystem::path& directory,
                                            const WriteOptions& options);
WrittenProblem write_coupling_problem(const std::string& name, const std::filesystem::path& directory,
                                      const WriteOptions& options);
WrittenProblem write_modal_set(const std::string& name, const std::filesystem::path& directory, const WriteOptions& options);

}  // namespace jointid::problems

#include "cli/problem/problem_kind.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "cli/options/complete_program.hpp"

namespace jointid::cli {
namespace {

const ProblemKind* find(std::span<const ProblemKind> kinds, const std::string& name) {
  const auto found = std::ranges::find_if(
      kinds, [&](const ProblemKind& kind) { return std::ranges::count(kind.list(), name, &problems::ProblemInfo::name) > 0; });
  return found == kinds.end() ? nullptr : &*found;
}

std::string nearest_name(std::span<const ProblemKind> kinds, const std::string& name) {
  std::vector<std::string> names;
  for (const ProblemKind& kind : kinds) {
    for (const problems::ProblemInfo& info : kind.list()) names.push_back(info.name);
  }
  return nearest_word(name, names);
}

}  // namespace

bool ProblemKinds::have(const std::string& name) const { return find(kinds, name) != nullptr; }

WrittenProblem ProblemKinds::write(const std::string& name, const std::filesystem::path& directory,
                                   const problems::WriteOptions& options) const {
  if (const ProblemKind* kind = find(kinds, name)) return kind->write(name, directory, options);
  const std::string near = nearest_name(kinds, name);
  const std::string more = all ? "" : std::string("; for more of them, ") + how_to_complete;
  throw InputError({.kind = ErrorKind::usage,
                    .file = {},
                    .place = "problem",
                    .problem = "there is no problem '" + name + "'",
                    .remedy = (near.empty() ? "list the problems to see their names" : "did you mean " + near + "?") + more});
}

}  // namespace jointid::cli

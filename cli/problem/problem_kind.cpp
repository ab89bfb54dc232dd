#include "cli/problem/problem_kind.hpp"

#include <algorithm>

#include "cli/options/complete_program.hpp"

namespace jointid::cli {
namespace {

const ProblemKind* find(std::span<const ProblemKind> kinds, const std::string& name) {
  const auto found = std::ranges::find_if(
      kinds, [&](const ProblemKind& kind) { return std::ranges::count(kind.list(), name, &problems::ProblemInfo::name) > 0; });
  return found == kinds.end() ? nullptr : &*found;
}

std::vector<std::string> names_of(std::span<const ProblemKind> kinds) {
  std::vector<std::string> names;
  for (const ProblemKind& kind : kinds) {
    for (const problems::ProblemInfo& info : kind.list()) names.push_back(info.name);
  }
  return names;
}

}  // namespace

bool ProblemKinds::have(const std::string& name) const { return find(kinds, name) != nullptr; }

WrittenProblem ProblemKinds::write(const std::string& name, const std::filesystem::path& directory,
                                   const problems::WriteOptions& options) const {
  if (const ProblemKind* kind = find(kinds, name)) return kind->write(name, directory, options);
  problems::refuse_problem("there is no problem '" + name + "'", name, names_of(kinds),
                           all ? "" : std::string("; for more of them, ") + how_to_complete);
}

}  // namespace jointid::cli

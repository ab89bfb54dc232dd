#include "cli/problem/problem_kind.hpp"

#include "cli/options/complete_program.hpp"

namespace jointid::cli {

bool ProblemKinds::have(const std::string& name) const { return problems::kind_of(kinds, name) != nullptr; }

problems::WrittenProblem ProblemKinds::write(const std::string& name, const std::filesystem::path& directory,
                                             const problems::WriteOptions& options) const {
  if (const problems::ProblemKind* kind = problems::kind_of(kinds, name)) return kind->write(name, directory, options);
  problems::refuse_problem("there is no problem '" + name + "'", name, problems::names_of(kinds),
                           all ? "" : std::string("; for more of them, ") + how_to_complete);
}

ProblemKinds linear_problems() { return {.kinds = problems::linear_kinds(), .all = false}; }

}  // namespace jointid::cli
